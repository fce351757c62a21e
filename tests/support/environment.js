// SPDX-License-Identifier: MIT
// Lets the tests in WebAssembly see the variables of the shell: which shard they are, for one.
Module.preRun = () => Object.assign(ENV, process.env);
