# SPDX-License-Identifier: Apache-2.0
"""Renders scenes of ours with Mitsuba 3, as peers.py asks it to: one JSON object a line in, one out.

  in   {"scene": FILE.yaml, "size": N, "sampler": NAME, "samples": N,
        "seed": N, "output": FILE.npy}
  out  {"seconds": CPU seconds of the rendering alone, "samples": rendered}; the output is an array (N, N, 4), Stokes components last
  the first line out: {"version": "3.9.1", "variant": NAME}

The kernel of a scene is compiled by a rendering that is not timed, scenes and output lie outside the time, one thread works. More
samples than PASS are rendered in passes.

What is translated: perspective camera, uniform background, rectangle lights, boxes, spheres and meshes of isotropic media of one
index, one within another by `priority`. Anything else is an error: no scene is to be compared with another one.
"""

import json
import sys
import time
from pathlib import Path

import drjit as dr
import mitsuba as mi
import numpy as np
import yaml

VARIANT = "llvm_ad_mono_polarized"
PASS = 1 << 24  # camera samples rendered at once


def only(mapping, *known):
    unknown = set(mapping) - set(known)
    if unknown:
        raise ValueError(f"cannot be translated for Mitsuba: {', '.join(sorted(unknown))}")


def transform_of(steps):
    """Steps of ours apply in order, each after the ones before."""
    whole = mi.ScalarTransform4f()
    for step in steps:
        only(step, "translate", "rotate", "scale")
        for kind, value in step.items():
            if kind == "translate":
                one = mi.ScalarTransform4f().translate(value)
            elif kind == "rotate":
                one = mi.ScalarTransform4f().rotate(value["axis"], value["angle"])
            else:
                one = mi.ScalarTransform4f().scale(value)
            whole = one @ whole
    return whole


def shape_of(shape, to_world, folder):
    [(kind, keys)] = shape.items()
    scale = mi.ScalarTransform4f().scale
    if kind == "sphere":
        only(keys, "radius")
        return {"type": "sphere", "to_world": to_world @ scale(keys["radius"])}
    if kind == "box":
        only(keys, "size")
        return {"type": "cube", "to_world": to_world @ scale([side / 2 for side in np.broadcast_to(keys["size"], 3).tolist()])}
    if kind == "rectangle":
        only(keys, "size")
        sides = np.broadcast_to(keys["size"], 2).tolist()
        return {"type": "rectangle", "to_world": to_world @ scale([sides[0] / 2, sides[1] / 2, 1])}
    if kind == "mesh":
        only(keys, "file")
        return {"type": "ply", "filename": str(folder / keys["file"]), "face_normals": True, "to_world": to_world}
    raise ValueError(f"cannot be translated for Mitsuba: {kind}")


def holds(outer, point):
    """Whether a ball or box holds a point; other solids hold none."""
    local = (outer["to_world"].inverse() @ mi.ScalarPoint3f(point)).numpy().reshape(3)
    if outer["type"] == "sphere":
        return np.linalg.norm(local) < 1
    return outer["type"] == "cube" and np.abs(local).max() < 1


def scene_of(file, size, sampler):
    """A scene of ours in Mitsuba's words."""
    ours = yaml.safe_load(file.read_text(encoding="utf-8"))
    only(ours, "title", "camera", "render", "background", "media", "objects")
    camera = ours["camera"]
    only(camera, "position", "target", "fov")
    theirs = {
        "type": "scene",
        # As deep as our trees: only Russian roulette ends a path.
        "integrator": {"type": "stokes", "integrator": {"type": "path", "max_depth": -1}},
        "sensor": {
            "type": "perspective",
            "fov": camera["fov"],
            "to_world": mi.ScalarTransform4f().look_at(camera["position"], camera["target"], [0, 0, 1]),
            "film": {
                "type": "hdrfilm", "width": size, "height": size, "rfilter": {"type": "box"},
                "pixel_format": "luminance", "component_format": "float32",
            },
            "sampler": {"type": sampler},
        },
    }
    if ours.get("background"):
        theirs["surroundings"] = {"type": "constant", "radiance": ours["background"]}
    solids = []
    for number, thing in enumerate(ours["objects"]):
        only(thing, "name", "shape", "transform", "medium", "priority", "emission")
        shape = shape_of(thing["shape"], transform_of(thing.get("transform", [])), file.parent)
        theirs[f"object{number}"] = shape
        if "emission" in thing:
            only(thing["emission"], "radiance")
            shape["emitter"] = {"type": "area", "radiance": float(thing["emission"]["radiance"])}
            shape["bsdf"] = {"type": "diffuse", "reflectance": 0.0}  # our lamps swallow what falls on them
        else:
            solids.append((thing.get("priority", 0), float(ours["media"][thing["medium"]]), shape))
    for priority, index, shape in solids:
        middle = (shape["to_world"] @ mi.ScalarPoint3f(0)).numpy().reshape(3).tolist()
        around = [solid for solid in solids if solid[0] < priority and holds(solid[2], middle)]
        outside = max(around, key=lambda solid: solid[0])[1] if around else 1.0
        shape["bsdf"] = {"type": "dielectric", "int_ior": index, "ext_ior": outside}
    return mi.load_dict(theirs)


def render(scene, samples, seed):
    """The Stokes components of one pass: the last twelve channels are S0.R, S0.G, S0.B, S1.R, ..., alike in R, G and B."""
    image = mi.render(scene, spp=samples, seed=seed)
    dr.eval(image)
    dr.sync_thread()
    return image


def main():
    mi.set_variant(VARIANT)
    dr.set_thread_count(1)
    say = sys.stdout
    sys.stdout = sys.stderr  # what libraries print is no answer
    print(json.dumps({"version": mi.__version__, "variant": VARIANT}), file=say, flush=True)
    scene, loaded, compiled = None, None, set()
    for line in sys.stdin:
        task = json.loads(line)
        size, samples = task["size"], task["samples"]
        once = max(1, min(samples, PASS // size**2))
        passes = max(1, round(samples / once))
        wanted = task["scene"], size, task["sampler"]
        if wanted != loaded:
            # Dr.Jit compiles for all shapes and surfaces that there are, so never more than one scene
            scene, compiled = None, set()
            scene, loaded = scene_of(Path(task["scene"]), size, task["sampler"]), wanted
        if once not in compiled:
            render(scene, once, 0)
            compiled.add(once)
        total = np.zeros((size, size, 4))
        start = time.process_time()
        for number in range(passes):
            total += np.asarray(render(scene, once, 1 + task["seed"] * (1 << 16) + number))[..., -12::3]
        seconds = time.process_time() - start
        np.save(task["output"], total / passes)
        print(json.dumps({"seconds": seconds, "samples": once * passes}), file=say, flush=True)


if __name__ == "__main__":
    main()
