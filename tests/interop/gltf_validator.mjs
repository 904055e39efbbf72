// gltf_validator.mjs FILE: prints the number of errors and warnings of Khronos' validator, and their messages.
import { readFileSync } from 'node:fs';
import { createRequire } from 'node:module';

const require = createRequire(`${process.env.INTEROP}/`);
const validator = require('gltf-validator');
const report = await validator.validateBytes(new Uint8Array(readFileSync(process.argv[2])));
console.log(`${report.issues.numErrors} errors, ${report.issues.numWarnings} warnings`);
for (const issue of report.issues.messages.filter((m) => m.severity < 2).slice(0, 5))
    console.log(`${issue.pointer}: ${issue.code}: ${issue.message}`);
