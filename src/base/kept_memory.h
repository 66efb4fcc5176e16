// Keeps freed memory in the process, so that the system need not clear it again.
#pragma once

namespace resect {

// For the main function of a program that repeatedly allocates and frees large arrays: up to a
// quarter of a gigabyte of freed memory stays with the process. By default the C library returns
// large arrays to the system, which clears each page before it is used again; rebuilding field and
// surface of 10^6 particles took a third longer. Without effect where the C library has no such
// setting.
void keepFreedMemory();

}  // namespace resect
