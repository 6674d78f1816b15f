// The numbers that the thesis printed (5.1.4 to 5.1.7), in milliseconds, copied as they stand.
// Mobile: Samsung Galaxy S7 Edge, Mali-T880 MP12. Laptop: GeForce GTX 860M. Desktop: GeForce GTX 970.
#include "lab/thesis_tables.h"

namespace vct {

std::vector<ThesisTable> thesisTables() {
    return {
        {"5.2",
         "Average time (ms) per frame for each scene; (*) when not voxelizing each frame",
         {"Scene 1", "Scene 2", "Scene 3", "Scene 4", "Scene 5"},
         {{"Mobile", {4.19, 6.38, 348.50, 393.19, 856.10}},
          {"Mobile(*)", {4.19, 6.38, 30.03, 74.72, 537.64}},
          {"Laptop", {1.11, 1.30, 6.06, 10.52, 27.16}},
          {"Laptop(*)", {1.11, 1.30, 2.24, 6.70, 23.34}},
          {"Desktop", {0.46, 0.64, 2.85, 4.81, 10.27}},
          {"Desktop(*)", {0.46, 0.64, 1.07, 3.03, 8.49}}}},
        {"5.3",
         "Average time (ms) per step for scene 5",
         {"CS", "RT", "V", "M", "Tr", "Tot"},
         {{"Mobile", {1.93, 2.53, 300.98, 17.48, 533.18, 856.10}},
          {"Laptop", {0.22, 0.89, 2.87, 0.96, 22.23, 27.16}},
          {"Desktop", {0.17, 0.35, 1.32, 0.47, 7.97, 10.27}}}},
        {"5.4",
         "Average time (ms) per frame of scene 5 for different shadow cone angles, when not voxelizing each "
         "frame",
         {"10 deg", "7.5 deg", "5 deg", "2.5 deg"},
         {{"Mobile", {291.57, 378.04, 536.82, 1076.49}},
          {"Laptop", {14.37, 17.11, 22.68, 38.31}},
          {"Desktop", {4.95, 5.88, 7.78, 12.50}}}},
        {"5.5",
         "Average time (ms) per step for voxel grids of 128^3 and 256^3; V and M over scenes 3 to 5, Tr for "
         "each",
         {"128 V", "128 M", "128 Tr 3", "128 Tr 4", "128 Tr 5", "256 V", "256 M", "256 Tr 3", "256 Tr 4",
          "256 Tr 5"},
         {{"Mobile", {247.64, 9.69, 14.59, 60.60, 484.38, 301.35, 17.93, 25.68, 70.32, 530.43}},
          {"Laptop", {0.75, 0.37, 0.64, 4.78, 19.08, 2.84, 0.99, 1.21, 5.54, 22.33}},
          {"Desktop", {0.51, 0.24, 0.31, 1.97, 7.00, 1.34, 0.48, 0.53, 2.26, 7.56}}}},
    };
}

}  // namespace vct
