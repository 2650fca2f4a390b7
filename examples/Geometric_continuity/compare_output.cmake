# Runs PROGRAM and compares its output with the file EXPECTED.
execute_process(COMMAND ${PROGRAM} OUTPUT_VARIABLE output RESULT_VARIABLE code)
file(READ ${EXPECTED} expected)
if(NOT code EQUAL 0)
  message(FATAL_ERROR "exit code ${code}\n${output}")
endif()
if(NOT output STREQUAL expected)
  message(FATAL_ERROR "unexpected output:\n${output}\nexpected:\n${expected}")
endif()
