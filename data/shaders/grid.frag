// What the lamp and the room do to the table plane y = 0 and to the topmost surface, at one place
// of the grid of SoShadowMaps. Its output is told there.
varying vec2 at;

uniform sampler2D heightMap, lampDepth;
uniform vec3 focus;         // m
uniform float radius;       // m
uniform vec2 lampRange;     // near and far distance of the lamp's map, m
uniform float lampTan;      // tangent of half its angle
uniform mat4 worldToLamp;   // to texture space

const float kLampRadius = 0.16;  // m
const float kGolden = 2.399963;  // rad: a spiral of even density

// Height of the topmost surface over the table, m, at a place of the grid; 0 where nothing stands.
float height(vec2 place) {
  return max(focus.y + radius * (1.0 - 2.0 * texture2D(heightMap, 0.5 + 0.5 * place).r), 0.0);
}

vec2 spiral(int k, float count, float turn) {
  float r = sqrt((float(k) + 0.5) / count), a = kGolden * float(k) + turn;
  return r * vec2(cos(a), sin(a));
}

// Share of the room's light that a point at height y with this normal gets past its neighbours.
float openness(float y, vec3 normal, float turn) {
  float blocked = 0.0;
  for (int k = 0; k < 14; ++k) {
    // Denser towards the centre: contact counts most.
    vec2 s = spiral(k, 14.0, turn);
    vec2 o = 0.11 * s * length(s) + 0.003 * s;
    vec3 way = vec3(o.x, height(at + o / radius) - y, -o.y);
    blocked += max(0.0, dot(normalize(way), normal) - 0.05);
  }
  return clamp(1.0 - 1.35 * blocked / 14.0, 0.0, 1.0);
}

// Distance from the lamp along its axis of a depth of its map, m.
float distanceOf(float depth) {
  return lampRange.x * lampRange.y / (lampRange.y - depth * (lampRange.y - lampRange.x));
}

// Share of the lamp's disc seen from a point of the table: soft where the caster is far.
float lampSeen(vec3 point, float turn) {
  vec4 s = worldToLamp * vec4(point, 1.0);
  vec3 p = s.xyz / s.w;
  float here = distanceOf(p.z), texture = 1.0 / (2.0 * here * lampTan);
  float sum = 0.0, count = 0.0;
  for (int k = 0; k < 16; ++k) {
    float there = distanceOf(texture2D(lampDepth, p.xy + 0.030 * texture * spiral(k, 16.0, turn)).r);
    if (there < here - 0.002) {
      sum += there;
      count += 1.0;
    }
  }
  if (count < 0.5) return 1.0;
  float caster = sum / count;
  float soft = clamp(kLampRadius * (here - caster) / caster, 0.002, 0.035) * texture;
  float seen = 0.0;
  for (int k = 0; k < 20; ++k) {
    float there = texture2D(lampDepth, p.xy + soft * spiral(k, 20.0, turn)).r;
    seen += step(p.z - 0.002, there);
  }
  return seen / 20.0;
}

void main() {
  float turn = 6.2832 * fract(52.9829189 * fract(dot(gl_FragCoord.xy, vec2(0.06711056, 0.00583715))));
  vec3 point = vec3(focus.x + radius * at.x, 0.0, focus.z - radius * at.y);
  float top = height(at), e = 0.004;
  vec3 normal = normalize(vec3(height(at - vec2(e / radius, 0.0)) - height(at + vec2(e / radius, 0.0)),
                               2.0 * e,
                               height(at + vec2(0.0, e / radius)) - height(at - vec2(0.0, e / radius))));
  float fromTop = top > 0.0 ? openness(top + 0.001, normal, turn) : 1.0;
  gl_FragColor = vec4(openness(0.0, vec3(0.0, 1.0, 0.0), turn), lampSeen(point, turn), fromTop,
                      top / radius);
}
