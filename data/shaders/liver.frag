// Liver, shaded triangle by triangle.
varying vec3 eyePosition;
varying vec3 objectPosition;
varying vec3 objectNormal;
varying float cutShare;
varying vec3 baseColor;

void main() {
  vec3 n = normalize(gl_FrontFacing ? objectNormal : -objectNormal);  // open surfaces have a back
  gl_FragColor = vec4(liver(objectPosition, widest(objectPosition), n, cutOrRim(cutShare, objectPosition), eyePosition, baseColor), 1.0);
}
