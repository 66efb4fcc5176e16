// What liver.glsl must know of each pixel, for SoShadeOnce.
varying vec3 eyePosition;
varying vec3 objectPosition;
varying vec3 objectNormal;
varying float cutShare;

void main() {
  gl_FragData[0] = vec4(objectPosition, cutOrRim(cutShare, objectPosition));
  // The normal's octahedral map (Meyer et al. 2010).
  bool facing = gl_FrontFacing || dot(gl_NormalMatrix * objectNormal, eyePosition) < 0.0;
  vec3 n = facing ? objectNormal : -objectNormal;
  n /= abs(n.x) + abs(n.y) + abs(n.z);
  vec2 turned = (1.0 - abs(n.yx)) * vec2(n.x < 0.0 ? -1.0 : 1.0, n.y < 0.0 ? -1.0 : 1.0);
  gl_FragData[1] = vec4(n.z < 0.0 ? turned : n.xy, eyePosition.z, widest(objectPosition));
}
