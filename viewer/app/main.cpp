// SPDX-License-Identifier: Apache-2.0
#include <array>

#include "cli/program.h"
#include "viewer/app/view_command.h"

int main(int argc, char** argv) {
    constexpr std::array more{pol::add_view_command};
    return pol::run_program(argc, argv, more);
}
