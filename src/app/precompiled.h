// The precompiled header of the window and of the program resect. No file includes this one by
// name.
#pragma once

#include "inventor/hand/operating_session.h"
#include "operation/precompiled.h"

// Qt's headers come after Inventor's.
#include <QMainWindow>
#include <QString>
#include <QTimer>
