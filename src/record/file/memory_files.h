// Lets SQLite read a database and its write-ahead log that are in memory, and nothing else.
//
// For the child that reads recordings of others (record/file/foreign_recording.h): it can open no
// file.
#pragma once

#include "base/raw_array.h"

namespace resect {

// A recording's file and the log beside it (-wal), as they are on the disk. SQLite joins the two,
// as it does after a program was killed, and writes into this memory only.
struct RecordingBytes {
  RawArray<char> file, log;  // log: empty where there is none
};

// Prepares SQLite for use in a child process of one thread, before the sandbox is entered: locks
// that other threads of the parent may have held when it forked are not taken. No database of the
// parent may be used afterwards.
void prepareSqliteInChild();

// The name of SQLite's VFS that serves `bytes` under the name "recording", and a log beside it. One
// at a time; `bytes` must live as long as a database that was opened with it.
const char* memoryFiles(RecordingBytes& bytes);

}  // namespace resect
