# Writes the page as texts of C++: what stands before and what stands behind the data. Called as
#   cmake -DFOLDER=… -DSCRIPTS=a.js,b.js -DOUTPUT=….h -P embed.cmake
# Style and script are named by their hashes in the page's policy, so that no other one is executed.

# The SHA-256 of a text as a source of a Content-Security-Policy: in base 64.
function(policy_source text result)
  string(SHA256 hex "${text}")
  string(APPEND hex 00) # 33 bytes: 11 groups of 4 letters, of which the last one is padding
  set(letters ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/)
  set(base64 "")
  foreach(group RANGE 10)
    math(EXPR begin "6 * ${group}")
    string(SUBSTRING ${hex} ${begin} 6 digits)
    foreach(shift 18 12 6 0)
      math(EXPR index "(0x${digits} >> ${shift}) & 63")
      string(SUBSTRING ${letters} ${index} 1 letter)
      string(APPEND base64 ${letter})
    endforeach()
  endforeach()
  string(REGEX REPLACE "A$" "=" base64 ${base64})
  set(${result} "sha256-${base64}" PARENT_SCOPE)
endfunction()

# A file as it is: brackets and semicolons must not be taken for those of lists.
function(read_text name result)
  file(READ "${FOLDER}/${name}" text)
  set(${result} "${text}" PARENT_SCOPE)
endfunction()

read_text(page.html page)
read_text(page.css style)
set(script "'use strict';\n")
string(REPLACE "," ";" names "${SCRIPTS}")
foreach(name IN LISTS names)
  read_text(${name} text)
  string(APPEND script "${text}")
endforeach()

policy_source("${style}" style_hash)
policy_source("${script}" script_hash)
string(REPLACE "@STYLE_HASH@" "${style_hash}" page "${page}")
string(REPLACE "@SCRIPT_HASH@" "${script_hash}" page "${page}")
string(REPLACE "@STYLE@" "${style}" page "${page}")
string(REPLACE "@SCRIPT@" "${script}" page "${page}")
string(FIND "${page}" "@DATA@" place)
string(SUBSTRING "${page}" 0 ${place} before)
math(EXPR place "${place} + 6")
string(SUBSTRING "${page}" ${place} -1 behind)
file(WRITE "${OUTPUT}" "// Made from the files of the folder report/.\n"
     "const char* const page_before_data = R\"=====(${before})=====\";\n"
     "const char* const page_behind_data = R\"=====(${behind})=====\";\n")
