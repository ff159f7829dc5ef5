// SPDX-License-Identifier: Apache-2.0
// engine/polarization/bounds.h in single precision, after measures.glsl. Half widths of bars, which the engine takes as
// differences of nearly equal numbers, are written without that cancellation: a bar of 1e-9 is a bar.
//
// Light up to `missing` may have to be added to an estimate, light up to `surplus` taken away; surplus <= missing.

// Bar of part/S0, (low, high).
vec2 share_bounds(float part, float s0, float missing, float surplus) {
    float total = s0 + missing - surplus;
    if (!(total > 0.0)) return vec2(0.0, 1.0);
    float radius = missing + surplus;
    float ceiling = max(1.0, s0 > 0.0 ? part / s0 : 1.0);
    return vec2(max(0.0, (part - radius) / total), min(ceiling, (part + radius) / total));
}

// Largest distance of that bar from part/S0. Requires: s0 > 0.
float share_half_width(float part, float s0, float missing, float surplus) {
    float estimate = part / s0;
    float total = s0 + missing - surplus;
    if (!(total > 0.0)) return max(estimate, 1.0 - estimate);
    float radius = missing + surplus;
    float drift = estimate * (missing - surplus);
    float up = min(max(1.0, estimate) - estimate, (radius - drift) / total);
    float down = min(estimate, (radius + drift) / total);
    return max(up, down);
}

// Half the angle under which a ball at `distance` is seen; `unknown` if it covers the origin.
float half_viewing_angle(float radius, float distance, float unknown) {
    if (radius == 0.0 && distance > 0.0) return 0.0;
    if (!(radius < distance)) return unknown;
    float x = radius / distance;
    return arc(x, sqrt((1.0 - x) * (1.0 + x))) / 2.0;
}

// Largest angle between the true azimuth and the estimated one.
float azimuth_bound(Measures m, float radius) {
    return half_viewing_angle(radius, m.linear, pi / 2.0);
}

// Bar of the ellipticity angle, (low, high).
vec2 ellipticity_angle_bounds(Measures m, float radius) {
    float spread = half_viewing_angle(radius, m.polarized, pi / 2.0);
    return vec2(max(-pi / 4.0, m.ellipticity_angle - spread), min(pi / 4.0, m.ellipticity_angle + spread));
}

// Bar of the ellipticity b/a, (low, high).
vec2 ellipticity_bounds(Measures m, float radius) {
    vec2 chi = ellipticity_angle_bounds(m, radius);
    bool may_be_linear = chi.x <= 0.0 && chi.y >= 0.0;
    vec2 sizes = abs(chi);
    return vec2(may_be_linear ? 0.0 : tan(min(sizes.x, sizes.y)), tan(max(sizes.x, sizes.y)));
}

// Largest distance of that bar from m.ellipticity. Requires: m.has_polarization.
//
// With e = tan(chi), t = tan(spread): tan(chi + spread) - e = t (1 + e^2) / (1 - e t), and likewise for the difference.
// The gap to circular light is 1 - e = (linear + polarized - |S3|) / (linear + polarized).
float ellipticity_half_width(Measures m, float s3, float radius) {
    float e = m.ellipticity;
    float whole = m.linear + m.polarized;
    float gap = (m.linear + m.linear * (m.linear / (m.polarized + abs(s3)))) / whole;
    if (!(radius < m.polarized)) return max(e, gap);
    float x = radius / m.polarized;
    float t = x / (1.0 + sqrt((1.0 - x) * (1.0 + x)));
    float t_to_circular = gap / (1.0 + e);
    float up = t < t_to_circular ? t * (1.0 + e * e) / (1.0 - e * t) : gap;
    float down = t < e ? t * (1.0 + e * e) / (1.0 + e * t) : e;
    return max(up, down);
}
