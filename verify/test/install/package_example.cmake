# Installs BUILD into an empty prefix, builds the first ```cpp block of SOURCE/README.md against what was installed, runs
# it as `example cube.off tetrahedron.off` where those two files are, and compares its output with the next ```text block.

set(work ${BUILD}/package_example)
file(REMOVE_RECURSE ${work})
file(MAKE_DIRECTORY ${work})

function(run)
  execute_process(COMMAND ${ARGV} WORKING_DIRECTORY ${work} RESULT_VARIABLE status OUTPUT_VARIABLE output
                  ERROR_VARIABLE output)
  if(NOT status EQUAL 0)
    list(JOIN ARGV " " command)
    message(NOTICE "${output}")
    message(FATAL_ERROR "status ${status} of ${command}")
  endif()
  set(output "${output}" PARENT_SCOPE)
endfunction()

# Sets `block` to the text of the first fenced block of that language in `text`, and `text` to what follows it.
function(take_block language)
  string(FIND "${text}" "\n```${language}\n" begin)
  if(begin EQUAL -1)
    message(FATAL_ERROR "README.md: no \`\`\`${language} block where the example is expected")
  endif()
  string(LENGTH "\n```${language}\n" fence)
  math(EXPR begin "${begin} + ${fence}")
  string(SUBSTRING "${text}" ${begin} -1 text)
  string(FIND "${text}" "```" end)
  string(SUBSTRING "${text}" 0 ${end} block)
  string(SUBSTRING "${text}" ${end} -1 text)
  set(block "${block}" PARENT_SCOPE)
  set(text "${text}" PARENT_SCOPE)
endfunction()

run(${CMAKE_COMMAND} --install ${BUILD} --prefix ${work}/prefix)

if(NOT EXISTS ${SOURCE}/README.md)
  message(FATAL_ERROR "README.md: not there; its first C++ block is the example that this test builds")
endif()
file(READ ${SOURCE}/README.md text)
take_block(cpp)
file(WRITE ${work}/example.cpp "${block}")
take_block(text)
set(expected "${block}")

foreach(model cube tetrahedron)
  file(COPY ${SOURCE}/verify/test/install/${model}.off DESTINATION ${work})
endforeach()
run(${CMAKE_COMMAND} -S ${SOURCE}/verify/test/install -B ${work}/build -G ${GENERATOR} -D CMAKE_BUILD_TYPE=Release
    -D CMAKE_PREFIX_PATH=${work}/prefix -D CMAKE_CXX_COMPILER=${COMPILER} -D CMAKE_CXX_COMPILER_LAUNCHER=${LAUNCHER}
    -D EXAMPLE=${work}/example.cpp)
run(${CMAKE_COMMAND} --build ${work}/build)
run(${work}/build/both_prefixes)

run(${work}/build/example cube.off tetrahedron.off)
if(NOT output STREQUAL expected)
  message(NOTICE "printed:\n${output}\nexpected:\n${expected}")
  message(FATAL_ERROR "the README's example does not print what the README says")
endif()
message(STATUS "the README's example printed what the README says")

# The program is installed where it was built, and works from there.
if(EXISTS ${work}/prefix/bin/tetracone)
  run(${work}/prefix/bin/tetracone collide cube.off tetrahedron.off)
  if(NOT output STREQUAL "1\n")
    message(FATAL_ERROR "the installed program says of two models that collide: ${output}")
  endif()
endif()
