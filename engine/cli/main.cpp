// SPDX-License-Identifier: Apache-2.0
// The program without a window (POL_VIEWER=OFF).
#include "cli/program.h"

int main(int argc, char** argv) {
    return pol::run_program(argc, argv, {});
}
