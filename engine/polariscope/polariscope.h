// SPDX-License-Identifier: Apache-2.0
// Polarized light through glass, crystals and metals, traced backward from a camera: the whole library.
//
//     load_scene -> compile -> render      a picture: Stokes vectors per pixel and wavelength    (render.h, picture.h)
//                           -> explain     one pixel: every branch of its tree                   (explain.h)
//                           -> trace_ray   any one ray                                           (plan.h)
//     read_picture, write_exr, evaluate, draw, write_png                                         (picture.h, maps.h)
//
// Nothing here throws or ends the program: what can fail gives a Result (result.h). All numbers are double. Objects are
// cheap to copy, never change, and may be used from any number of threads at once.
#pragma once

#include "polariscope/assets.h"
#include "polariscope/explain.h"
#include "polariscope/light.h"
#include "polariscope/maps.h"
#include "polariscope/picture.h"
#include "polariscope/plan.h"
#include "polariscope/render.h"
#include "polariscope/result.h"
#include "polariscope/scene.h"
