// Keeps the pixels of tissue that plain.glsl does not show: cut, bloody, heated, or with a structure
// below the skin.
uniform sampler2D places;
uniform vec2 texel;  // size of one, as a share of the texture

void main() {
  vec4 place = texture2D(places, gl_FragCoord.xy * texel);
  vec2 blood = bloodPerMetre.x == 0.0 ? vec2(0.0) : texture3D(bloodMap, (place.xyz - bloodLow) * bloodPerMetre).ra;
  // tissueAt() moves the edge of a cut by up to 0.22, and the border begins at 0.34.
  bool plain = place.w < 0.12 && blood.x + blood.y == 0.0 && heatAt(place.xyz).x == 0.0 &&
               structureAt(place.xyz).x < 0.04;
  if (plain) discard;
  gl_FragColor = vec4(1.0);
}
