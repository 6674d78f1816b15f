// Errors that calls throw, for tests of messages.
#pragma once

#include <gtest/gtest.h>

#include <initializer_list>
#include <string>

#include "core/error.h"

namespace vct::test {

// The message of the vct::Error that `call` throws, or "".
template <class Call>
std::string errorOf(const Call& call) {
    try {
        call();
        return "";
    } catch (const Error& error) {
        return error.what();
    }
}

inline void expectMentions(const std::string& text, std::initializer_list<std::string> words) {
    for (const std::string& word : words)
        EXPECT_NE(text.find(word), std::string::npos) << "'" << word << "' is not in: " << text;
}

}  // namespace vct::test
