// How many threads does VTK use?
#pragma once

namespace resect::bench {

void setVtkThreads(int threads);  // >= 1

}  // namespace resect::bench
