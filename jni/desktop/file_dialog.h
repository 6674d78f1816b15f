// The desktop's dialog to choose a file, by a program that shows it: zenity or kdialog.
#pragma once

#include <sys/types.h>

#include <optional>
#include <string>

namespace vct::desktop {

class FileDialog {
  public:
    // Shows the dialog. Throws vct::Error if neither program is installed.
    FileDialog();
    ~FileDialog();  // closes it
    FileDialog(const FileDialog&) = delete;
    FileDialog& operator=(const FileDialog&) = delete;

    // Returns the path once the user has chosen a file, "" if the user has chosen none, and nothing before.
    std::optional<std::string> poll();

  private:
    pid_t process_ = -1;  // -1: it has ended
    int output_ = -1;
};

}  // namespace vct::desktop
