// Number of threads of VTK.
#pragma once

namespace resect::bench {

void setVtkThreads(int threads);  // >= 1

}  // namespace resect::bench
