// Tissue that is neither cut, bloody nor heated: liver.glsl leaves the code for these out.
#define PLAIN
