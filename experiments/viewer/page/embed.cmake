# embed.cmake: cmake -D OUT=FILE.cpp -D FOLDER=this folder -D THREE=three.min.js or empty -P embed.cmake
# Writes the definitions of viewer_files.h: the files as raw strings.

set(text "#include \"experiments/viewer/viewer_files.h\"\n\nnamespace tetracone::experiments::viewer {\n")
foreach(name page.html pair.html scene.html style.css bodies.js bounds.js boxes.js camera.js pair.js scene.js three.js)
  set(file "${FOLDER}/${name}")
  if(name STREQUAL "three.js")
    set(file "${THREE}")
  endif()
  set(content "")
  if(file)
    file(READ "${file}" content)
  endif()
  string(REPLACE "." "_" variable "${name}")
  string(APPEND text "const std::string_view ${variable} = R\"~viewer~(${content})~viewer~\";\n")
endforeach()
file(WRITE "${OUT}" "${text}}  // namespace tetracone::experiments::viewer\n")
