// Whether limits of the address space can be tested: sanitizers reserve far more than there is.
#pragma once

namespace candela::test {

#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
inline constexpr bool can_limit_address_space = false;
#elif defined(__has_feature)
#if __has_feature(address_sanitizer) || __has_feature(thread_sanitizer)
inline constexpr bool can_limit_address_space = false;
#else
inline constexpr bool can_limit_address_space = true;
#endif
#else
inline constexpr bool can_limit_address_space = true;
#endif

}  // namespace candela::test
