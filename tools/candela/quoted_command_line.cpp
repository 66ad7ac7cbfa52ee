#include "tools/candela/quoted_command_line.h"

#include <algorithm>
#include <cctype>
#include <cstring>

namespace candela::cli {
namespace {

bool is_plain(const std::string& word) {
  return !word.empty() && std::all_of(word.begin(), word.end(), [](char c) {
    return std::isalnum(static_cast<unsigned char>(c)) || std::strchr("-_./,=:+@%", c);
  });
}

std::string quoted(const std::string& word) {
  std::string text = "'";
  for (const char c : word) text += c == '\'' ? std::string("'\\''") : std::string(1, c);
  return text + '\'';
}

}  // namespace

std::string quoted_command_line(const std::vector<std::string>& words) {
  std::string line = "candela";
  for (const std::string& word : words) line += ' ' + (is_plain(word) ? word : quoted(word));
  return line;
}

}  // namespace candela::cli
