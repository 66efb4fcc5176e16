// Keeps freed memory in the process, so that the system need not clear it again.
#pragma once

namespace resect {

// To be called by the main function of a program that repeatedly allocates and frees large arrays.
// Up to a quarter of a gigabyte of freed memory then stays with the process, from arrays of up to
// 32 MB each. By default the C library returns large arrays to the system, which clears each page
// before it is used again: rebuilding field and surface of 10^6 particles then takes a third
// longer. The call has no effect where the C library is not glibc.
void keepFreedMemory();

}  // namespace resect
