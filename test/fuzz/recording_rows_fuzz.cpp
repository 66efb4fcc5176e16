#include "fuzz_target.h"
#include "small_tables.h"

// The child's answer, as this process reads it.
RESECT_FUZZ_TARGET(resect::test::smallTables().add(bytes))
