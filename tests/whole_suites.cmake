# Read by CTest before it runs anything: each suite of `programs` whose name begins with one of
# `labels` becomes one CTest test, so that a thousand short tests need not start a thousand times.
foreach(program ${programs})
  execute_process(COMMAND ${program} --gtest_list_tests OUTPUT_VARIABLE listing
    COMMAND_ERROR_IS_FATAL ANY)
  foreach(label ${labels})
    string(TOLOWER ${label} lower)
    string(REGEX MATCHALL "\n${label}_[^. \n]+" suites "\n${listing}")
    foreach(suite ${suites})
      string(STRIP ${suite} suite)
      add_test(${suite} ${program} --gtest_filter=${suite}.*)
      set_tests_properties(${suite} PROPERTIES LABELS ${lower})
    endforeach()
  endforeach()
endforeach()
