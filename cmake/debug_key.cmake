# cmake -DKEYTOOL=... -DKEYSTORE=... -P debug_key.cmake: creates the debug key if it does not exist, with the names and
# the password that Android's tools expect.
if(EXISTS ${KEYSTORE})
    return()
endif()
get_filename_component(folder ${KEYSTORE} DIRECTORY)
file(MAKE_DIRECTORY ${folder})
execute_process(COMMAND ${KEYTOOL} -genkeypair -keystore ${KEYSTORE} -storetype pkcs12 -storepass android
    -keypass android -alias androiddebugkey -dname "CN=Android Debug,O=Android,C=US" -keyalg RSA -keysize 2048
    -validity 10950 RESULT_VARIABLE result OUTPUT_VARIABLE text ERROR_VARIABLE text)
if(NOT result EQUAL 0)
    message(FATAL_ERROR "keytool cannot make the debug key ${KEYSTORE}: ${text}")
endif()
