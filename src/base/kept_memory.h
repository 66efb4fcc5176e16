// How does memory that was freed come back without the system clearing it again?
#pragma once

namespace resect {

// For the main function of a program that makes and drops large arrays again and again: what is
// freed stays with the process, up to a quarter of a gigabyte. Otherwise the C library gives
// arrays back as soon as they are freed, and the system clears each page before it hands it out
// anew; to build the field and surface of 10^6 particles again took a third longer. Where the C
// library has no such setting, nothing changes.
void keepFreedMemory();

}  // namespace resect
