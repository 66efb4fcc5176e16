// Keeps freed memory in the process, so that the system need not clear it again.
#pragma once

namespace resect {

// Call this in the main function of a program that repeatedly allocates and frees large arrays. Up
// to a quarter of a gigabyte of freed memory then stays with the process; arrays of more than 32 MB
// are still returned to the system. Without the call, the C library returns large arrays to the
// system, which clears each page before the page is used again. For example, without the call it
// takes a third longer to rebuild the field and the surface of 10^6 particles. The call has an
// effect only if the C library is glibc.
void keepFreedMemory();

}  // namespace resect
