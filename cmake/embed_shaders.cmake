# cmake -DSHADERS=FOLDER -DOUTPUT=FILE.cpp -P embed_shaders.cmake: writes the shaders as string literals into a C++ file
# (jni/api/embedded_shaders.h).
file(GLOB_RECURSE files RELATIVE ${SHADERS} ${SHADERS}/*)
list(SORT files)
set(code "#include \"api/embedded_shaders.h\"\n\nnamespace vct {\n\nconst EmbeddedFile embeddedFiles[] = {\n")
foreach(file ${files})
    file(READ ${SHADERS}/${file} text)
    string(APPEND code "{\"${file}\", R\"shader(${text})shader\"},\n")
endforeach()
string(APPEND code "{nullptr, nullptr}};\n\n}  // namespace vct\n")
file(WRITE ${OUTPUT} "${code}")
