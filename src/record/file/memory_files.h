// A virtual file system (VFS) of SQLite that has two files, both in memory: a database and its
// write-ahead log.
//
// The child process that reads recordings from untrusted sources (record/file/foreign_recording.h)
// uses this VFS, since that process cannot open files.
#pragma once

#include "base/raw_array.h"

namespace resect {

// The contents of a recording's file and of the write-ahead log beside it (-wal). SQLite applies
// the log to the file, as it does after a program was killed. SQLite writes into this memory only.
struct RecordingBytes {
  RawArray<char> file, log;  // log: empty if there is none
};

// Prepares SQLite for use in a child process with one thread. To be called before the sandbox is
// entered. From then on SQLite takes no locks. With locks, the child could wait forever: if another
// thread of the parent held a lock at the fork, nobody would release it in the child. Databases
// that the parent has opened must not be used in the child.
void prepareSqliteInChild();

// Makes the VFS serve `bytes` and returns the name of the VFS. In this VFS, the file name of the
// database is "recording". The VFS serves one RecordingBytes at a time. `bytes` must outlive every
// database that is opened with it.
const char* memoryFiles(RecordingBytes& bytes);

}  // namespace resect
