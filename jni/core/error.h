// The three kinds of error, and when each is used:
//   assert        A programming mistake, which no input can cause.
//   vct::Error    Anything that input, the driver or the machine can cause. The message is one sentence that
//                 names what failed, why, and what to do about it; main() prints it and exits with 1.
//   return value  An expected result (two pictures differ).
#pragma once

#include <string>

#include "vct/error.h"
