// SPDX-License-Identifier: Apache-2.0
// The parts of the scene panel that edit one kind of thing each.
#pragma once

#include <string>

#include "viewer/panels/edit_form.h"

namespace pol {

void draw_camera_section(EditForm& form);
void draw_media_section(EditForm& form);
void draw_light_section(EditForm& form);
/// `wavelengths` is the text being typed; empty: the scene's own.
void draw_render_section(EditForm& form, std::string& wavelengths);

}  // namespace pol
