// The three kinds of error, and when each is used:
//   assert       a mistake of the programmer: cannot happen whatever the input
//   vct::Error   everything that input, the driver or the machine can cause: one sentence that names what
//                failed, why, and what to do about it; main() prints it and exits with 1
//   return value what is expected to happen (two pictures differ)
#pragma once

#include <string>

#include "vct/error.h"
