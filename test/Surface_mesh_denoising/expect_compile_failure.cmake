# Builds TARGET and fails unless every one of its SOURCES gives an error that matches MESSAGE and
# (if ERRORS is not empty) ERRORS errors in all.
if(GENERATOR MATCHES Ninja)
  set(keep_going -- -k 0)
elseif(GENERATOR MATCHES Makefiles)
  set(keep_going -- -k)
endif()
set(ENV{LC_ALL} C)
execute_process(
  COMMAND ${CMAKE_COMMAND} --build ${BUILD_DIR} --config ${CONFIG} --target ${TARGET} ${keep_going}
  RESULT_VARIABLE result OUTPUT_VARIABLE output ERROR_VARIABLE output)

string(REGEX MATCHALL "error: [^\n]*" errors "${output}")
list(LENGTH errors number_of_errors)
list(FILTER errors INCLUDE REGEX "${MESSAGE}")
list(LENGTH errors number_of_messages)

message("${output}")
if(result EQUAL 0)
  message(FATAL_ERROR "${TARGET} compiles")
endif()
if(NOT number_of_messages EQUAL SOURCES)
  message(FATAL_ERROR "${number_of_messages} messages, expected ${SOURCES}")
endif()
if(NOT "${ERRORS}" STREQUAL "")
  math(EXPR expected "${SOURCES} * ${ERRORS}")
  if(NOT number_of_errors EQUAL expected)
    message(FATAL_ERROR "${number_of_errors} errors, expected ${expected}")
  endif()
endif()
