#include <span>

#include "fuzz_target.h"
#include "record/file/frame_bytes.h"

RESECT_FUZZ_TARGET(resect::frameFromBytes(std::as_bytes(std::span(bytes)), {}))
