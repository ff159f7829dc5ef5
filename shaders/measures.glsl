// SPDX-License-Identifier: Apache-2.0
// engine/polarization/measures.h in single precision; tests hold both to 1e-6 relative. Stokes vectors are
// vec4(S0, S1, S2, S3), with components that are 0 or between 1e-30 and 1e30.

const float pi = 3.14159265358979;

struct Measures {
    float linear;             // length of the linear part
    float polarized;          // length of the polarized part
    float dop;
    float dolp;
    float docp;
    float ellipticity;        // b/a
    float ellipticity_angle;  // radians
    float chirality;          // S3 / polarized = sin(2 ellipticity_angle)
    float azimuth;            // radians, -pi/2 to pi/2
    bool is_light;            // false: nothing else means anything
    bool has_light;
    bool has_polarization;
    bool has_azimuth;
};

bool is_finite(float x) {
    return !isnan(x) && !isinf(x);
}

bool is_finite(vec4 v) {
    return is_finite(v.x) && is_finite(v.y) && is_finite(v.z) && is_finite(v.w);
}

// sqrt(a^2 + b^2) that neither overflows nor underflows.
float hypotenuse(float a, float b) {
    float longer = max(abs(a), abs(b));
    if (longer == 0.0) return 0.0;
    float ratio = min(abs(a), abs(b)) / longer;
    return longer * sqrt(1.0 + ratio * ratio);
}

// atan2 to a few units in the last place, which the built-in atan does not promise. After atanf of the Cephes library.
float arc(float y, float x) {
    float a = abs(y);
    float b = abs(x);
    float longer = max(a, b);
    if (longer == 0.0) return 0.0;
    float t = min(a, b) / longer;
    bool is_steep = t > 0.41421356;  // tan(pi/8)
    float u = is_steep ? (t - 1.0) / (t + 1.0) : t;
    float z = u * u;
    float angle = (((8.05374449538e-2 * z - 1.38776856032e-1) * z + 1.99777106478e-1) * z - 3.33329491539e-1) * z * u + u;
    if (is_steep) angle += pi / 4.0;
    if (a > b) angle = pi / 2.0 - angle;
    if (x < 0.0) angle = pi - angle;
    return y < 0.0 ? -angle : angle;
}

// Parts of the vector up to `tau` S0 count as rounding noise.
Measures measure(vec4 s, float tau) {
    Measures m;
    m.linear = hypotenuse(s.y, s.z);
    m.polarized = hypotenuse(m.linear, s.w);
    m.dop = m.dolp = m.docp = m.ellipticity = m.ellipticity_angle = m.chirality = m.azimuth = 0.0;
    m.has_light = m.has_polarization = m.has_azimuth = false;
    m.is_light = is_finite(s) && (s.x > 0.0 || (s.x == 0.0 && m.polarized == 0.0));
    if (!m.is_light || s.x == 0.0) return m;

    m.has_light = true;
    m.dop = m.polarized / s.x;
    m.dolp = m.linear / s.x;
    m.docp = abs(s.w) / s.x;
    m.has_polarization = m.dop > tau;
    m.has_azimuth = m.dolp > tau;
    if (m.has_polarization) {
        m.ellipticity = abs(s.w) / (m.polarized + m.linear);
        m.ellipticity_angle = arc(s.w, m.linear) / 2.0;
        m.chirality = s.w / m.polarized;
    }
    if (m.has_azimuth) m.azimuth = arc(s.z, s.y) / 2.0;
    return m;
}
