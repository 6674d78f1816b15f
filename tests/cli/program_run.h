// Runs of `vct` in an empty folder: their output and their files.
#pragma once

#include <gtest/gtest.h>
#include <sys/wait.h>

#include <algorithm>
#include <cstdlib>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "support/temporary_folder.h"

namespace vct::test {

class ProgramRun {
  public:
    // An absolute path, as the program runs elsewhere.
    static constexpr const char* cornell = VCT_SOURCE_DIR "/assets/cornell.glb";

    // `before`: shell text in front of the program, such as a variable or a limit. Returns the exit status.
    int run(const std::string& arguments, const std::string& before = "") {
        const std::string command = "cd '" + folder.path() + "' && " + before + " '" + VCT_PROGRAM + "' " +
                                    arguments + " > '" + said.file("out") + "' 2> '" + said.file("err") + "'";
        const int status = std::system(command.c_str());
        out = readBytes(said.file("out"));
        err = readBytes(said.file("err"));
        return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
    }

    void expectSuccess(const std::string& arguments) { EXPECT_EQ(run(arguments), 0) << arguments << err; }

    nlohmann::json json(const std::string& name) const {
        return nlohmann::json::parse(readBytes(folder.file(name)), nullptr, false);
    }

    TemporaryFolder folder;  // working folder
    std::string out, err;

  private:
    TemporaryFolder said;
};

inline auto lineCount(const std::string& text) {
    return std::count(text.begin(), text.end(), '\n');
}

}  // namespace vct::test
