// Smooth random patterns in space. Hash without sine: the same on every card.

float hash(vec3 p) {
  p = fract(p * 0.1031);
  p += dot(p, p.zyx + 31.32);
  return fract((p.x + p.y) * p.z);
}

// Value in [-1, 1] (x) and gradient (yzw) of a lattice noise with one cell per unit; derivative
// after Quilez 2008.
vec4 noise(vec3 x) {
  vec3 i = floor(x), f = x - i;
  vec3 u = f * f * f * (f * (f * 6.0 - 15.0) + 10.0);
  vec3 du = 30.0 * f * f * (f * (f - 2.0) + 1.0);
  float a = hash(i), b = hash(i + vec3(1, 0, 0)), c = hash(i + vec3(0, 1, 0)),
        d = hash(i + vec3(1, 1, 0)), e = hash(i + vec3(0, 0, 1)), g = hash(i + vec3(1, 0, 1)),
        h = hash(i + vec3(0, 1, 1)), k = hash(i + vec3(1, 1, 1));
  float k1 = b - a, k2 = c - a, k3 = e - a;
  float k4 = a - b - c + d, k5 = a - c - e + h, k6 = a - b - e + g;
  float k7 = -a + b + c - d + e - g - h + k;
  float value = a + k1 * u.x + k2 * u.y + k3 * u.z + k4 * u.x * u.y + k5 * u.y * u.z +
                k6 * u.z * u.x + k7 * u.x * u.y * u.z;
  vec3 slope = du * vec3(k1 + k4 * u.y + k6 * u.z + k7 * u.y * u.z,
                         k2 + k5 * u.z + k4 * u.x + k7 * u.z * u.x,
                         k3 + k6 * u.x + k5 * u.y + k7 * u.x * u.y);
  return vec4(2.0 * value - 1.0, 2.0 * slope);
}

// The same in the plane: value (x) and gradient (yz).
vec3 noise2(vec2 x) {
  vec2 i = floor(x), f = x - i;
  vec2 u = f * f * f * (f * (f * 6.0 - 15.0) + 10.0);
  vec2 du = 30.0 * f * f * (f * (f - 2.0) + 1.0);
  float a = hash(vec3(i, 0.0)), b = hash(vec3(i + vec2(1, 0), 0.0)),
        c = hash(vec3(i + vec2(0, 1), 0.0)), d = hash(vec3(i + vec2(1, 1), 0.0));
  float k1 = b - a, k2 = c - a, k3 = a - b - c + d;
  return vec3(2.0 * (a + k1 * u.x + k2 * u.y + k3 * u.x * u.y) - 1.0,
              2.0 * du * vec2(k1 + k3 * u.y, k2 + k3 * u.x));
}

// Grains that fill space, one per unit: the way from the middle of the grain in which x lies (xyz), and
// how near the border to the next grain is: 1 on it, 0 from a tenth of a grain on (w). Of the 27 grains
// that may be nearest, only the 8 likely ones are looked at.
vec4 grains(vec3 x) {
  vec3 first = floor(x - 0.5), way = vec3(0.0);
  float least = 9.0, next = 9.0;
  for (int k = 0; k < 8; ++k) {
    vec3 cell = first + vec3(mod(float(k), 2.0), mod(floor(float(k) / 2.0), 2.0), floor(float(k) / 4.0));
    float h = hash(cell);
    vec3 off = x - cell - 0.5 - 0.62 * (fract(h * vec3(1.0, 57.31, 131.7)) - 0.5);
    float distance2 = dot(off, off);
    if (distance2 < least) {
      next = least;
      least = distance2;
      way = off;
    } else {
      next = min(next, distance2);
    }
  }
  return vec4(way, 1.0 - smoothstep(0.02, 0.14, sqrt(next) - sqrt(least)));
}

// How far x moves within a pixel.
float widest(vec3 x) {
  vec3 wide = fwidth(x);
  return max(wide.x, max(wide.y, wide.z));
}

// 1 where the pattern noise(x) is wider than a pixel, 0 where it is finer and would only flicker;
// wide: widest(x).
float finer(float wide) { return 1.0 - smoothstep(0.35, 0.9, wide); }
