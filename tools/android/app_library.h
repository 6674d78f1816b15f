// Loads the app's library as Android does: from the APK, into a namespace of the linker that sees the app's
// own libraries and, of the system's, only those that are public.
#pragma once

#include <string>

namespace stand_in {

// `folder` has the app's libraries: "APK!/lib/ABI". Ends the program with a message if the library cannot be
// loaded.
void* loadAppLibrary(const std::string& folder, const std::string& name);

}  // namespace stand_in
