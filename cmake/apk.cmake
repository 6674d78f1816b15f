# The target `apk` packs libvct.so, shaders/ and the scenes and skies of assets/ into a signed APK, without Gradle. It needs the build
# tools of Android's SDK (in the folder ANDROID_HOME, or Debian's packages aapt, apksigner and android-framework-res),
# a JDK's keytool and Python.
find_package(Python3 COMPONENTS Interpreter)
file(GLOB sdk_tools $ENV{ANDROID_HOME}/build-tools/*)
file(GLOB sdk_platforms $ENV{ANDROID_HOME}/platforms/android-*)
# The newest version comes first.
list(SORT sdk_tools COMPARE NATURAL ORDER DESCENDING)
list(SORT sdk_platforms COMPARE NATURAL ORDER DESCENDING)
find_program(VCT_AAPT2 aapt2 HINTS ${sdk_tools})
find_program(VCT_APKSIGNER apksigner HINTS ${sdk_tools})
find_program(VCT_KEYTOOL keytool HINTS $ENV{JAVA_HOME}/bin)
find_file(VCT_ANDROID_FRAMEWORK NAMES android.jar framework-res.apk
    HINTS ${sdk_platforms} PATHS /usr/share/android-framework-res NO_CMAKE_FIND_ROOT_PATH)
foreach(tool Python3_EXECUTABLE VCT_AAPT2 VCT_APKSIGNER VCT_KEYTOOL VCT_ANDROID_FRAMEWORK)
    if(NOT ${tool})
        list(APPEND missing ${tool})
    endif()
endforeach()
if(missing)
    # Only this target fails, because a build by Gradle needs none of these tools.
    add_custom_target(apk VERBATIM
        COMMAND ${CMAKE_COMMAND} -E echo "apk: not found: ${missing}. Install Android's SDK and set ANDROID_HOME, or on \
Debian: apt install aapt apksigner android-framework-res default-jdk-headless python3. Then configure again."
        COMMAND ${CMAKE_COMMAND} -E false)
    return()
endif()

set(manifest ${CMAKE_SOURCE_DIR}/app/src/main/AndroidManifest.xml)
set(versions ${CMAKE_SOURCE_DIR}/gradle/libs.versions.toml)
set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${manifest} ${versions})
foreach(name minSdk targetSdk)
    file(STRINGS ${versions} line REGEX "^${name} = ")
    string(REGEX MATCH "[0-9]+" ${name} "${line}")
endforeach()
# Adds the attributes that Gradle takes from app/build.gradle and does not allow in the manifest. The libraries are
# stored uncompressed and aligned, so Android maps them directly from the APK and unpacks nothing.
file(READ ${manifest} text)
string(REPLACE "<manifest " "<manifest package=\"vct.app\" " text "${text}")
string(REPLACE "<application" "<application android:extractNativeLibs=\"false\"" text "${text}")
set(stage ${CMAKE_BINARY_DIR}/apk)
file(WRITE ${stage}/AndroidManifest.xml.in "${text}")
configure_file(${stage}/AndroidManifest.xml.in ${stage}/AndroidManifest.xml COPYONLY)

file(GLOB_RECURSE resources CONFIGURE_DEPENDS app/src/main/res/*.xml)
add_custom_command(OUTPUT ${stage}/resources.zip VERBATIM
    COMMAND ${VCT_AAPT2} compile --dir ${CMAKE_SOURCE_DIR}/app/src/main/res -o ${stage}/resources.zip
    DEPENDS ${resources})
add_custom_command(OUTPUT ${stage}/base.apk VERBATIM
    COMMAND ${VCT_AAPT2} link -o ${stage}/base.apk -I ${VCT_ANDROID_FRAMEWORK} --manifest ${stage}/AndroidManifest.xml
        --min-sdk-version ${minSdk} --target-sdk-version ${targetSdk}
        --version-code 1 --version-name ${PROJECT_VERSION} ${stage}/resources.zip
    DEPENDS ${stage}/resources.zip ${stage}/AndroidManifest.xml)

# The shared libraries: libvct.so without debug information (the unstripped file stays in the build folder for
# ndk-stack), and the C++ library.
set(libraries ${stage}/libvct.so)
add_custom_command(OUTPUT ${stage}/libvct.so VERBATIM
    COMMAND ${CMAKE_STRIP} --strip-unneeded -o ${stage}/libvct.so $<TARGET_FILE:vct>
    DEPENDS vct)
if(ANDROID_STL STREQUAL "c++_shared")
    list(APPEND libraries ${CMAKE_SYSROOT}/usr/lib/${CMAKE_LIBRARY_ARCHITECTURE}/libc++_shared.so)
endif()

# Android Studio signs with the same key, so that its APK and this one can replace each other.
set(android_user $ENV{ANDROID_USER_HOME})
if(NOT android_user)
    file(TO_CMAKE_PATH "$ENV{HOME}/.android" android_user)
endif()
set(keystore ${android_user}/debug.keystore)

file(GLOB_RECURSE shaders CONFIGURE_DEPENDS shaders/*)
file(GLOB scenes CONFIGURE_DEPENDS assets/*.glb assets/*.hdr)
add_custom_command(OUTPUT ${CMAKE_BINARY_DIR}/vct.apk VERBATIM
    COMMAND ${Python3_EXECUTABLE} ${CMAKE_SOURCE_DIR}/tools/apk/pack.py ${stage}/base.apk ${stage}/unsigned.apk
        --abi ${ANDROID_ABI} --libraries ${libraries}
        --assets ${CMAKE_SOURCE_DIR}/shaders=shaders ${CMAKE_SOURCE_DIR}/assets=scenes
    COMMAND ${CMAKE_COMMAND} -DKEYTOOL=${VCT_KEYTOOL} -DKEYSTORE=${keystore}
        -P ${CMAKE_SOURCE_DIR}/cmake/debug_key.cmake
    COMMAND ${VCT_APKSIGNER} sign --ks ${keystore} --ks-pass pass:android --ks-key-alias androiddebugkey
        --out ${CMAKE_BINARY_DIR}/vct.apk ${stage}/unsigned.apk
    DEPENDS ${stage}/base.apk ${libraries} ${shaders} ${scenes} ${CMAKE_SOURCE_DIR}/tools/apk/pack.py
    COMMENT "Packing and signing vct.apk")
add_custom_target(apk DEPENDS ${CMAKE_BINARY_DIR}/vct.apk)
