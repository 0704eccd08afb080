// SPDX-License-Identifier: BSD-3-Clause
// The image of the firmware on avr8js, with pins and wire in the hands of whoever writes here: a
// line of JSON asks for a while of virtual time, a line of JSON answers what came of it.
//
//     node run.js IMAGE.hex EEPROM_IN_HEX BAUD
//     {"ms": 1.0, "send": "02...", "positions": [512, ...]}
//     {"sent": "", "duty": [0, 0, 0], "enabled": false, "cycle": 16000, "overruns": 0,
//      "worst_delay": 0, "slept": [[from, to], ...]}
//
// The timers that make the PWM are left out: their registers say what there is to know.
import fs from 'node:fs';
import readline from 'node:readline';
import * as avr from 'avr8js';
import {Receiver} from './receiver.js';

const FREQUENCY = 16e6;
const CYCLES_PER_MS = FREQUENCY / 1000;
const BITS_OF_A_BYTE = 10;  // with start and stop
const SLEEP = 0x9588, SEI = 0x9478, RETI = 0x9518;
const OCR1A = 0x88, OCR1B = 0x8a, OCR2B = 0xb4, PORT_B = 0x25, PORT_D = 0x2b;

function readImage(path) {
  const program = new Uint16Array(16384);
  const bytes = new Uint8Array(program.buffer);
  for (const line of fs.readFileSync(path, 'utf8').split('\n')) {
    if (line[0] !== ':' || line.slice(7, 9) !== '00') continue;
    const data = Buffer.from(line.slice(9, 9 + 2 * parseInt(line.slice(1, 3), 16)), 'hex');
    bytes.set(data, parseInt(line.slice(3, 7), 16));
  }
  return program;
}

const cpu = new avr.CPU(readImage(process.argv[2]), 2048);
const portB = new avr.AVRIOPort(cpu, avr.portBConfig);
const portD = new avr.AVRIOPort(cpu, avr.portDConfig);
new avr.AVRTimer(cpu, avr.timer0Config);
const adc = new avr.AVRADC(cpu, avr.adcConfig);
const usart = new avr.AVRUSART(cpu, avr.usart0Config, FREQUENCY);
const clock = new avr.AVRClock(cpu, FREQUENCY, avr.clockConfig);
new avr.AVRWatchdog(cpu, avr.watchdogConfig, clock);
const memory = new avr.EEPROMMemoryBackend(1024);
memory.memory.set(Buffer.from(process.argv[3], 'hex'));
new avr.AVREEPROM(cpu, memory, avr.eepromConfig);

portD.setPin(2, false);  // stop line closed
portD.setPin(6, true);   // drivers well
portB.setPin(3, true);   // buttons up
portB.setPin(4, true);

let sent = [];
usart.onByteTransmit = (byte) => sent.push(byte);
const receiver = new Receiver(cpu, usart, BITS_OF_A_BYTE * FREQUENCY / Number(process.argv[4]));

/// A processor asleep does nothing until the next thing happens; returns the cycles it skipped.
function sleepUntil(end) {
  let until = end;
  if (cpu.nextClockEvent) until = Math.min(until, cpu.nextClockEvent.cycles);
  const next = receiver.next();
  if (next !== null) until = Math.min(until, Math.max(next, cpu.cycles + 1));
  if (until > cpu.cycles) cpu.cycles = until;
}

let asleep = false;

function run(ms) {
  const end = cpu.cycles + Math.round(ms * CYCLES_PER_MS);
  const slept = [];
  while (cpu.cycles < end) {
    receiver.feed();
    if (asleep) {
      const from = cpu.cycles;
      sleepUntil(end);
      const last = slept[slept.length - 1];
      if (last && last[1] === from) last[1] = cpu.cycles;
      else slept.push([from, cpu.cycles]);
    } else {
      const code = cpu.progMem[cpu.pc];
      asleep = code === SLEEP && cpu.nextInterrupt < 0;
      avr.avrInstruction(cpu);
      // one more instruction comes before any interrupt, so that nothing gets between sei and sleep
      if (code === SEI || code === RETI) continue;
    }
    const before = cpu.pc;
    cpu.tick();
    if (cpu.pc === before) continue;
    // an interrupt was taken: avr8js counts two of its four cycles, and none of a wake's four
    cpu.cycles += asleep ? 6 : 2;
    asleep = false;
  }
  return slept;
}

function duty(register, back) {
  return back ? -cpu.data[register] : cpu.data[register];
}

function answer(request) {
  (request.positions ?? []).forEach((counts, joint) => {
    adc.channelValues[joint] = ((counts + 0.5) * 5) / 1024;
  });
  receiver.send(Buffer.from(request.send ?? '', 'hex'));
  const slept = run(request.ms);
  const enabled = Boolean(cpu.data[PORT_D] & (1 << 5));
  const reply = {
    sent: Buffer.from(sent).toString('hex'),
    duty: [
      duty(OCR1A, cpu.data[PORT_D] & (1 << 4)),
      duty(OCR1B, cpu.data[PORT_D] & (1 << 7)),
      duty(OCR2B, cpu.data[PORT_B] & 1),
    ],
    enabled,
    cycle: cpu.cycles,
    overruns: receiver.overruns,
    worst_delay: receiver.worstDelay,
    slept,
  };
  sent = [];
  return reply;
}

for await (const line of readline.createInterface({input: process.stdin})) {
  process.stdout.write(JSON.stringify(answer(JSON.parse(line))) + '\n');
}
