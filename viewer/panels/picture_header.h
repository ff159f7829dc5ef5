// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "film/stokes_image.h"
#include "viewer/session/session.h"
#include "viewer/session/wishes.h"

namespace pol {

/// What is known of a picture beside its pixels, and what its numbers are taken for, to change. Requires: a document
/// without a scene is shown.
void draw_picture_header(const Session& session, Wishes& wishes);

/// "64 x 48 pixels", and which part of the whole picture that is: "64 x 48 pixels from 100,20 of 1920 x 1080".
std::string size_text(const StokesImage& picture);

/// "16-bit floats: off by at most 0.049 % each".
std::string stored_text(const StoredNumbers& stored);

/// "580 nm", "R (S3 was not measured)".
std::string measured_text(const Band& band);

}  // namespace pol
