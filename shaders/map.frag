// SPDX-License-Identifier: Apache-2.0
// The picture as maps::evaluate and maps::colorize would have it, one fragment per device pixel of the viewport.
// After evaluate.glsl and the constants of picture/picture_renderer.cpp, which say what this variant is for: `over_intensity`,
// `is_difference`, `is_reduced`. A software rasterizer runs both sides of every branch, so one program for all maps
// would cost as much as all of them.

uniform sampler2D stokes;        // S0..S3 of the shown wavelength, behind the polarimeter
uniform sampler2D left_out;      // residual, S0 of the tail, samples or minus the unphysical part, S0 that is no light (negative: no sample yet)
uniform sampler2D red;           // red of S0, S1, S2, S3 as the color picture weighs them, before the polarimeter
uniform sampler2D green;
uniform sampler2D blue;
uniform sampler2D difference;    // from the reference: value, weight, state, 1 where it is known
uniform sampler2D scale_colors;  // two rows: linear sRGB, and as it is encoded for the screen

uniform vec2 origin;             // of the picture in the viewport, device pixels, y down
uniform float zoom;              // device pixels per pixel of the picture
uniform float hatch;             // points per pixel of the picture
uniform float viewport_height;   // device pixels
uniform vec4 background;

uniform float low;               // value at the beginning of the scale
uniform float high;              // value at its end
uniform bool fades;              // weak polarization is drawn with less than full weight
uniform bool fades_by_bar;       // and so is what has a wide error bar
uniform bool has_polarimeter;
uniform vec4 polarimeter_row;          // S0 behind the polarimeter
uniform float gain;
uniform float offset;
uniform float gamma;
uniform vec3 ground;             // linear, what fading ends in
uniform vec3 state_colors[state_count];  // sRGB, by state
uniform vec3 other_stripes[state_count];  // the same: every second stripe of what is hatched

out vec4 fragment;

const bool needs_color = quantity == quantity_color || over_intensity;

Light light_at(ivec2 at) {
    vec4 error = texelFetch(left_out, at, 0);
    vec3 color = vec3(0.0);
    if (needs_color) {
        vec4 r = texelFetch(red, at, 0);
        vec4 g = texelFetch(green, at, 0);
        vec4 b = texelFetch(blue, at, 0);
        color = has_polarimeter ? vec3(dot(polarimeter_row, r), dot(polarimeter_row, g), dot(polarimeter_row, b)) : vec3(r.x, g.x, b.x);
    }
    return Light(texelFetch(stokes, at, 0), error.x, error.y, unphysical_part(error.z), max(error.z, 0.0), error.w,
                 color, error.w >= 0.0);
}

// Mean of the pixels first <= p <= last, of at most 8 x 8 of them: light adds, maps of it do not. The worst defect counts.
Light mean_light(ivec2 first, ivec2 last) {
    ivec2 stride = max(ivec2(1), (last - first + 8) / 8);
    Light mean = Light(vec4(0.0), 0.0, 0.0, 0.0, 0.0, 0.0, vec3(0.0), false);
    float count = 0.0;
    for (int y = first.y; y <= last.y; y += stride.y) {
        for (int x = first.x; x <= last.x; x += stride.x) {
            Light one = light_at(ivec2(x, y));
            if (!one.is_sampled) continue;
            count += 1.0;
            mean.stokes += one.stokes;
            mean.residual += one.residual;
            mean.surplus += one.surplus;
            if (isnan(one.unphysical) || one.unphysical > mean.unphysical) mean.unphysical = one.unphysical;
            mean.samples += one.samples;
            mean.no_light += one.no_light;
            mean.color += one.color;
        }
    }
    mean.is_sampled = count > 0.0;
    mean.stokes /= count;
    mean.residual /= count;
    mean.surplus /= count;
    mean.samples /= count;
    mean.no_light /= count;
    mean.color /= count;
    return mean;
}

// Of the pixels first <= p <= last the one that differs most: a single wrong pixel must not drown. Not known: state -1.
MapPixel worst_difference(ivec2 first, ivec2 last) {
    ivec2 stride = max(ivec2(1), (last - first + 8) / 8);
    MapPixel worst = empty(-1);
    for (int y = first.y; y <= last.y; y += stride.y) {
        for (int x = first.x; x <= last.x; x += stride.x) {
            vec4 one = texelFetch(difference, ivec2(x, y), 0);
            if (one.w == 0.0 || worst.state == state_not_a_number) continue;
            int state = int(one.z);
            bool is_defect = state == state_not_a_number || state == state_unphysical;
            bool is_more = state == state_defined && worst.state != state_unphysical && (worst.state != state_defined || abs(one.x) > abs(worst.value));
            if (worst.state == -1 || is_defect || is_more) worst = MapPixel(one.x, one.y, state, 1.0);
        }
    }
    return worst;
}

vec3 srgb_encode(vec3 linear) {
    vec3 inside = clamp(linear, 0.0, 1.0);
    return mix(12.92 * inside, 1.055 * pow(inside, vec3(1.0 / 2.4)) - 0.055, greaterThan(inside, vec3(0.0031308)));
}

// Offset and gamma of a photograph; `light` is already exposed.
vec3 developed(vec3 light) {
    vec3 shifted = light + offset;
    return gamma == 1.0 ? shifted : pow(max(shifted, vec3(0.0)), vec3(1.0 / gamma));
}

// The texture's filter is linear between the nodes of the scale, which stand at every kink.
vec3 scale_color(float t, bool encoded) {
    float nodes = float(textureSize(scale_colors, 0).x);
    return texture(scale_colors, vec2((clamp(t, 0.0, 1.0) * (nodes - 1.0) + 0.5) / nodes, encoded ? 0.75 : 0.25)).rgb;
}

vec3 photograph(vec3 light) {
    return is_finite(vec4(light, 0.0)) ? srgb_encode(developed(gain * light)) : state_colors[state_not_a_number];
}

// sRGB of the shown map; `at` in points from the picture's corner. Of a difference the weight has the certainty in it.
vec3 map_color(MapPixel pixel, ivec2 at) {
    if (pixel.state != state_defined) return (at.x + at.y) / 2 % 4 < 2 ? state_colors[pixel.state] : other_stripes[pixel.state];
    float t = (pixel.value - low) / (high - low);
    if (is_photograph && !is_difference) t = developed(vec3(t)).x;
    if (!fades_with_carrier && !fades_by_bar) return scale_color(t, true);
    float weight = (fades ? pixel.weight : 1.0) * (fades_by_bar ? pixel.certainty : 1.0);
    return srgb_encode(mix(ground, scale_color(t, false), weight));
}

void main() {
    vec2 view = vec2(gl_FragCoord.x, viewport_height - gl_FragCoord.y);
    vec2 p = (view - origin) / zoom;
    ivec2 size = textureSize(stokes, 0);
    fragment = background;
    if (any(lessThan(p, vec2(0.0))) || any(greaterThanEqual(p, vec2(size)))) return;

    Light light;
    ivec2 first = ivec2(p);
    ivec2 last = first;
    if (is_reduced) {
        // Pixels whose centers lie under this device pixel: every one of the picture is under exactly one.
        first = max(ivec2(ceil(p - 0.5 / zoom - 0.5)), ivec2(0));
        last = min(ivec2(ceil(p + 0.5 / zoom - 0.5)) - 1, size - 1);
        light = mean_light(first, last);
    } else {
        light = light_at(first);
    }
    if (!light.is_sampled) return;
    vec3 shown;
    if (quantity == quantity_color) {
        shown = photograph(light.color);
    } else if (is_difference) {
        MapPixel most = worst_difference(first, last);
        if (most.state < 0) return;
        shown = map_color(most, ivec2(p * hatch));
    } else {
        shown = map_color(evaluate(light), ivec2(p * hatch));
    }
    if (over_intensity && quantity != quantity_color) {
        vec3 exposed = developed(gain * light.color);
        shown *= srgb_encode(vec3(dot(exposed, vec3(0.2126, 0.7152, 0.0722)))).x;
    }
    fragment = vec4(shown, 1.0);
}
