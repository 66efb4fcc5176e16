// Initialises Open Inventor (the library Coin).
#pragma once

namespace resect {

// Initialises Coin's database, node kits and interaction, and Resect's own node types. Only the
// first call in a process has an effect. Only one thread of a process may use Inventor, since
// Debian's Coin is built without thread safety; this function must be called in that thread. After
// the call, Coin loads no shared library if a file contains an unknown node type.
void initInventor();

}  // namespace resect
