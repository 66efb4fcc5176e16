// Initialises Open Inventor (the library Coin).
#pragma once

namespace resect {

// Initialises Coin's database, node kits and interaction, and Resect's own node types. Only the
// first call in a process has an effect. Call it from the one thread that uses Inventor: Debian's
// Coin is built without thread safety. From then on Coin loads no shared library when a file names
// an unknown node type.
void initInventor();

}  // namespace resect
