// SPDX-License-Identifier: Apache-2.0
// engine/maps/evaluate.cpp in single precision: the formula of each map. After measures.glsl, bounds.glsl and the
// constants of viewer/picture/shader_constants.h: the names of quantities, states and carriers, and what is known of the
// one quantity that this program is for.

uniform float brightest;    // trace bound of the light that any path can bring
uniform float d65;          // 0: not known
uniform bool is_measured;    // the Stokes components that the quantity needs are known
uniform float noise;        // pixel_noise
uniform float full_weight;  // full_weight_polarization
uniform float dark_below;   // dark_share of the S0 of the picture's brightest pixel

struct Light {
    vec4 stokes;
    float residual;
    float surplus;
    float unphysical;
    float samples;
    float no_light;
    vec3 color;
    bool is_sampled;
};

// LightFloats::left_out of viewer/picture/picture_floats.h: samples, or minus the unphysical part.
float unphysical_part(float counted) {
    return isnan(counted) ? counted : max(0.0, -counted);
}

struct MapPixel {
    float value;
    float weight;
    int state;
    float certainty;
};

MapPixel number(float value) {
    return MapPixel(value, 1.0, is_finite(value) ? state_defined : state_not_a_number, 1.0);
}

MapPixel empty(int state) {
    return MapPixel(0.0, 0.0, state, 1.0);
}

// evaluate_light of engine/maps/evaluate.cpp.
MapPixel evaluate(Light light) {
    if (quantity == quantity_poincare) return empty(state_undefined);  // of one picture
    if (!is_measured) return empty(state_not_measured);
    if (quantity == quantity_intensity) return d65 == 0.0 ? empty(state_undefined) : number(light.stokes.x / d65);
    if (quantity == quantity_residual) return number(light.residual);
    if (quantity == quantity_unphysical) return number(light.unphysical);
    if (quantity == quantity_samples) {
        if (isnan(light.unphysical)) return empty(state_not_a_number);
        return light.unphysical > 0.0 ? empty(state_unphysical) : number(light.samples);
    }

    vec4 s = light.stokes;
    float surplus = light.surplus;
    float missing = light.residual * brightest + surplus;
    Measures m = measure(s, noise);
    if (!is_finite(s) || !is_finite(missing)) return empty(state_not_a_number);
    if (!m.is_light || surplus < 0.0 || light.residual < 0.0) return empty(state_unphysical);
    if (s.x + missing <= light.no_light) return empty(state_no_light);
    int unknown = s.x + missing < dark_below ? state_dark : state_undetermined;
    if (!m.has_light) return empty(unknown);

    float radius = missing + surplus;
    vec2 dop_bar = share_bounds(m.polarized, s.x, missing, surplus);
    vec2 dolp_bar = share_bounds(m.linear, s.x, missing, surplus);
    float value = 0.0;
    float spread = 0.0;  // width of the bar, half of the quantity's range being 1
    if (quantity == quantity_dop) {
        value = m.dop;
        spread = 2.0 * (dop_bar.y - dop_bar.x);
    } else if (quantity == quantity_dolp) {
        value = m.dolp;
        spread = 2.0 * (dolp_bar.y - dolp_bar.x);
    } else if (quantity == quantity_docp) {
        vec2 bar = share_bounds(abs(s.w), s.x, missing, surplus);
        value = m.docp;
        spread = 2.0 * (bar.y - bar.x);
    } else if (quantity == quantity_ellipticity) {
        vec2 bar = ellipticity_bounds(m, radius);
        value = m.ellipticity;
        spread = 2.0 * (bar.y - bar.x);
    } else if (quantity == quantity_handedness) {
        vec2 bar = ellipticity_angle_bounds(m, radius);
        value = m.chirality;
        spread = (bar.y - bar.x) / (pi / 4.0);
    } else if (quantity == quantity_azimuth) {
        value = degrees(m.azimuth);
        spread = azimuth_bound(m, radius) / (pi / 4.0);
    } else if (quantity == quantity_s1 || quantity == quantity_s2 || quantity == quantity_s3) {
        float part = quantity == quantity_s1 ? s.y : quantity == quantity_s2 ? s.z : s.w;
        value = part / s.x;
        spread = 2.0 * radius / s.x;
    } else if (quantity == quantity_dop_error) {
        value = share_half_width(m.polarized, s.x, missing, surplus);
    } else if (quantity == quantity_ellipticity_error) {
        value = m.has_polarization ? ellipticity_half_width(m, s.w, radius) : 0.0;
    } else if (quantity == quantity_azimuth_error) {
        value = degrees(azimuth_bound(m, radius));
    }

    bool is_linear = carrier == carrier_linear_part;
    bool is_there = carrier == carrier_light || (is_linear ? m.has_azimuth : m.has_polarization);
    // Where the polarized part is known to be next to nothing, its direction is not unknown but without meaning.
    float most = is_linear ? dolp_bar.y : dop_bar.y;
    bool is_unpolarized = fades_with_carrier && most < full_weight;
    bool is_determined = spread < 1.0;
    if (!is_determined && !is_unpolarized) return empty(unknown);
    if (!is_there || !is_determined) return empty(state_undefined);
    float weight = fades_with_carrier ? min(1.0, (is_linear ? m.dolp : m.dop) / full_weight) : 1.0;
    return MapPixel(value, weight, state_defined, 1.0 - spread);
}
