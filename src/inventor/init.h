// Initialises Open Inventor (Coin).
#pragma once

namespace resect {

// Initialises Coin's database, node kits and interaction, once per process; later calls cost
// nothing. Call it from the one thread that uses Inventor: Debian's Coin is built without thread
// safety. Forbids Coin to load shared libraries named after unknown node types.
void initInventor();

}  // namespace resect
