# Writes OUTPUT, version.cpp, for the commit that stands in SOURCE_DIR; touches it only when the commit is another one.
cmake_minimum_required(VERSION 3.25)
execute_process(COMMAND git describe --always --match "" WORKING_DIRECTORY ${SOURCE_DIR}
    OUTPUT_VARIABLE commit OUTPUT_STRIP_TRAILING_WHITESPACE ERROR_QUIET RESULT_VARIABLE status)
if(status EQUAL 0 AND NOT commit STREQUAL "")
    string(APPEND VERSION "+${commit}")
endif()
file(CONFIGURE OUTPUT ${OUTPUT} @ONLY CONTENT
"#include \"core/support/version.hpp\"

namespace momentscope {

const char* const PROGRAM_VERSION = \"@VERSION@\";

}  // namespace momentscope
")
