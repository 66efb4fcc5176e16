// A virtual file system (VFS) of SQLite that has two files, both in memory: a database and its
// write-ahead log.
//
// The child process that reads recordings of others uses it (record/file/foreign_recording.h),
// since it can open no files.
#pragma once

#include "base/raw_array.h"

namespace resect {

// A recording's file and the write-ahead log beside it (-wal), as they are on the disk. SQLite
// applies the log to the file, as it does after a program was killed. It writes into this memory
// only.
struct RecordingBytes {
  RawArray<char> file, log;  // log: empty if there is none
};

// Prepares SQLite for use in a child process with one thread; to be called before the sandbox is
// entered. From then on SQLite takes no locks. A lock that another thread of the parent held at the
// fork would never be released in the child. No database that the parent opened may be used in the
// child.
void prepareSqliteInChild();

// Makes the VFS serve `bytes` and returns its name; the database has the file name "recording". The
// VFS serves one RecordingBytes at a time. `bytes` must outlive every database that is opened with
// it.
const char* memoryFiles(RecordingBytes& bytes);

}  // namespace resect
