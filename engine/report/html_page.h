// SPDX-License-Identifier: Apache-2.0
// Self-contained HTML pages of one look: no script, no file beside them, light or dark as the reader prefers.
#pragma once

#include <string>

#include "maps/colorize.h"

namespace pol {

/// A whole document around `body`, which is HTML; `title` is plain text.
std::string html_page(const std::string& title, const std::string& body);

/// <img> with the picture inside, pixels not blended. `alt` is plain text.
std::string html_image(const RgbPicture& picture, const std::string& alt);

}  // namespace pol
