// By itself, because VTK 9.1's header is no C++20.
#include "peers/vtk/vtk_threads.h"

#include <vtkSMPTools.h>

namespace resect::bench {

void setVtkThreads(int threads) { vtkSMPTools::Initialize(threads); }

}  // namespace resect::bench
