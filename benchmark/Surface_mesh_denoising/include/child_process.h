// Copyright (c) 2026  The Surface_mesh_denoising authors.
// All rights reserved.
//
// This file is part of the CGAL-style package Surface_mesh_denoising.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Runs a task in a process of its own: its peak memory can be told apart, and it can crash or be stopped without
// consequences. For POSIX systems.

#ifndef SURFACE_MESH_DENOISING_CHILD_PROCESS_H
#define SURFACE_MESH_DENOISING_CHILD_PROCESS_H

#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstddef>
#include <cstdlib>
#include <cstring>
#include <exception>
#include <stdexcept>
#include <string>

#include <poll.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>
#ifdef __linux__
#include <malloc.h>
#include <sys/prctl.h>
#endif

namespace child_process {

struct Outcome
{
  std::string failure;    // empty if the task came to its end
  std::string result;     // the bytes that the task wrote
  double megabytes = 0;   // the most memory that the task took at a time, beyond what there was before it
};

// where a task writes its result: the end of a pipe
class Result_stream
{
public:
  explicit Result_stream(const int file) : m_file(file) {}

  void write(const void* data, std::size_t size)
  {
    const char* bytes = static_cast<const char*>(data);
    while(size > 0)
    {
      const ssize_t written = ::write(m_file, bytes, size);
      if(written < 0 && errno == EINTR)
        continue;
      if(written <= 0)
        _exit(EXIT_FAILURE); // nobody reads any more
      bytes += written;
      size -= std::size_t(written);
    }
  }

private:
  int m_file;
};

namespace internal {

inline double megabytes(const rusage& usage)
{
#ifdef __APPLE__
  return double(usage.ru_maxrss) / (1024 * 1024); // bytes
#else
  return double(usage.ru_maxrss) / 1024;          // kilobytes
#endif
}

enum class Ending : char { RESULT, EXCEPTION };

template <typename Task>
[[noreturn]] void run_as_child(const Task& task, const int file)
{
#ifdef __linux__
  prctl(PR_SET_PDEATHSIG, SIGKILL); // ends with its parent
#endif
  const rlimit no_core = { 0, 0 };
  setrlimit(RLIMIT_CORE, &no_core);

  Result_stream stream(file);
  rusage usage;
  getrusage(RUSAGE_SELF, &usage);
  const double megabytes_before = megabytes(usage);
  stream.write(&megabytes_before, sizeof(megabytes_before));

  try
  {
    task([&]() -> Result_stream&
    {
      const Ending ending = Ending::RESULT;
      stream.write(&ending, sizeof(ending));
      return stream;
    });
  }
  catch(const std::exception& e)
  {
    const Ending ending = Ending::EXCEPTION;
    stream.write(&ending, sizeof(ending));
    stream.write(e.what(), std::strlen(e.what()));
  }
  _exit(EXIT_SUCCESS);
}

} // namespace internal

// Runs `task(finish)` in a child process. The task calls `finish()` when its work is done, and writes its result to the
// stream that this returns. A task that takes longer than `time_out` seconds is stopped. Meanwhile, `wait()` is called
// several times a second.
template <typename Task, typename Wait>
Outcome run(const Task& task, const double time_out, const Wait& wait)
{
  int ends[2];
  if(pipe(ends) != 0)
    throw std::runtime_error(std::string("no pipe: ") + std::strerror(errno));
#ifdef __GLIBC__
  malloc_trim(0); // memory that is free, but held, would hide what the task takes
#endif
  const pid_t child = fork();
  if(child < 0)
    throw std::runtime_error(std::string("no child process: ") + std::strerror(errno));
  if(child == 0)
  {
    close(ends[0]);
    internal::run_as_child(task, ends[1]);
  }
  close(ends[1]);

  typedef std::chrono::steady_clock Clock;
  const Clock::time_point start = Clock::now();
  std::string bytes;
  bool is_stopped = false;
  char buffer[1 << 16];
  while(true)
  {
    pollfd event = { ends[0], POLLIN, 0 };
    const int ready = poll(&event, 1, 200);
    wait();
    if(ready > 0)
    {
      const ssize_t size = read(ends[0], buffer, sizeof(buffer));
      if(size < 0 && errno == EINTR)
        continue;
      if(size <= 0)
        break;
      bytes.append(buffer, std::size_t(size));
    }
    if(!is_stopped && std::chrono::duration<double>(Clock::now() - start).count() > time_out)
    {
      kill(child, SIGKILL);
      is_stopped = true;
    }
  }
  close(ends[0]);

  int status = 0;
  rusage usage;
  while(wait4(child, &status, 0, &usage) < 0 && errno == EINTR) {}

  Outcome outcome;
  double megabytes_before = 0;
  const std::size_t header_size = sizeof(megabytes_before) + sizeof(internal::Ending);
  if(bytes.size() >= sizeof(megabytes_before))
  {
    std::memcpy(&megabytes_before, bytes.data(), sizeof(megabytes_before));
    outcome.megabytes = internal::megabytes(usage) - megabytes_before;
  }

  if(is_stopped)
    outcome.failure = "stopped by the time-out";
  else if(WIFSIGNALED(status))
    outcome.failure = std::string("crashed: ") + strsignal(WTERMSIG(status));
  else if(WEXITSTATUS(status) != EXIT_SUCCESS || bytes.size() < header_size)
    outcome.failure = "ended without a result";
  else
  {
    outcome.result = bytes.substr(header_size);
    if(internal::Ending(bytes[header_size - 1]) == internal::Ending::EXCEPTION)
      outcome.failure.swap(outcome.result);
  }
  return outcome;
}

} // namespace child_process

#endif // SURFACE_MESH_DENOISING_CHILD_PROCESS_H
