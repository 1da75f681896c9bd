# Writes OUTPUT, the source of reye::output::commit(), for the sources in SOURCE; left alone where it says so already.
execute_process(COMMAND git -C "${SOURCE}" rev-parse --show-prefix OUTPUT_VARIABLE below RESULT_VARIABLE failed ERROR_QUIET
                OUTPUT_STRIP_TRAILING_WHITESPACE)
set(commit unknown)
if(NOT failed AND below STREQUAL "")   # no archive that lies inside the clone of something else
  execute_process(COMMAND git -C "${SOURCE}" rev-parse --short=12 HEAD OUTPUT_VARIABLE commit OUTPUT_STRIP_TRAILING_WHITESPACE
                  ERROR_QUIET)
  execute_process(COMMAND git -C "${SOURCE}" diff --quiet HEAD -- src apps RESULT_VARIABLE changed ERROR_QUIET)
  if(changed)
    string(APPEND commit +)
  endif()
endif()
file(CONFIGURE OUTPUT "${OUTPUT}" @ONLY CONTENT [[
#include "output/run/commit.hpp"

namespace reye::output {

const char* commit() { return "@commit@"; }

}  // namespace reye::output
]])
