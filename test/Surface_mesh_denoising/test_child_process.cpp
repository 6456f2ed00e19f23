// Copyright (c) 2026  The Surface_mesh_denoising authors.
// All rights reserved.
//
// This file is part of the CGAL-style package Surface_mesh_denoising.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "child_process.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <memory>
#include <stdexcept>
#include <string>

#include <unistd.h>

namespace {

template <typename Task>
child_process::Outcome run(const Task& task, const double time_out = 600)
{
  return child_process::run(task, time_out, []() {});
}

const auto do_nothing = [](const auto& finish) { finish(); };

// touches so much memory that it counts
void use_memory(const std::size_t megabytes)
{
  const std::size_t size = megabytes << 20;
  const std::unique_ptr<volatile char[]> memory(new volatile char[size]);
  for(std::size_t i=0; i<size; i+=512)
    memory[i] = 1;
}

} // namespace

TEST(Child_process, result_comes_back)
{
  const std::string message(1000000, 'x'); // more than a pipe holds
  const child_process::Outcome outcome = run([&](const auto& finish)
  {
    finish().write(message.data(), message.size());
  });
  EXPECT_EQ(outcome.failure, "");
  EXPECT_EQ(outcome.result, message);
}

TEST(Child_process, changes_stay_in_the_child)
{
  int value = 1;
  run([&](const auto& finish) { value = 2; finish(); });
  EXPECT_EQ(value, 1);
}

TEST(Child_process, exception_is_told)
{
  const child_process::Outcome outcome = run([](const auto&) { throw std::runtime_error("too hot"); });
  EXPECT_EQ(outcome.failure, "too hot");
  EXPECT_EQ(outcome.result, "");
}

TEST(Child_process, crash_is_told)
{
  EXPECT_NE(run([](const auto&) { std::abort(); }).failure.find("crashed"), std::string::npos);
  EXPECT_EQ(run(do_nothing).failure, "");
}

TEST(Child_process, exit_without_result_is_told)
{
  EXPECT_EQ(run([](const auto&) { _exit(0); }).failure, "ended without a result");
  EXPECT_EQ(run([](const auto&) { _exit(3); }).failure, "ended without a result");
}

TEST(Child_process, endless_task_is_stopped)
{
  const child_process::Outcome outcome = run([](const auto&) { while(true) pause(); }, 0.1);
  EXPECT_NE(outcome.failure.find("time-out"), std::string::npos);
}

TEST(Child_process, peak_memory_is_that_of_the_task)
{
  use_memory(200); // of the parent: does not count
  EXPECT_LT(run(do_nothing).megabytes, 50);
  const double megabytes = run([](const auto& finish) { use_memory(100); finish(); }).megabytes;
  EXPECT_GE(megabytes, 100);
  EXPECT_LT(megabytes, 150);
}
