<?xml version="1.0" encoding="utf-8"?>
<!-- SPDX-License-Identifier: BSD-3-Clause -->
<!DOCTYPE TS>
<TS version="2.1" language="tr" sourcelanguage="en">
<context>
    <name>Alarm</name>
    <message>
        <source>the tissue blew up: a position is not a number</source>
        <translation>doku patladı: bir konum sayı değil</translation>
    </message>
    <message>
        <source>the tissue blew up: a point moved %1 mm between two looks, at most %2 mm is right</source>
        <translation>doku patladı: bir nokta iki bakış arasında %1 mm yer değiştirdi, en çok %2 mm olmalı</translation>
    </message>
    <message>
        <source>the tissue blew up: its energy rose to %1 mJ, what it was given allows %2 mJ</source>
        <translation>doku patladı: enerjisi %1 mJ oldu, verilen enerji en çok %2 mJ için yeter</translation>
    </message>
    <message>
        <source>a link was stretched to %1 times its length at rest, at most %2 times is right</source>
        <translation>bir bağ durgun boyunun %1 katına gerildi, en çok %2 katı olmalı</translation>
    </message>
    <message>
        <source>a link was squeezed to %1 % of its length at rest, at least %2 % is right</source>
        <translation>bir bağ durgun boyunun %%1 kadarına sıkıştı, en az %%2 kalmalı</translation>
    </message>
    <message>
        <source>a tetrahedron was squeezed to %1 % of its volume at rest, at least %2 % is right</source>
        <translation>bir dörtyüzlü durgun hacminin %%1 kadarına sıkıştı, en az %%2 kalmalı</translation>
    </message>
    <message>
        <source>the tissue was moved by %1 mm; there a linear solid is good for %2 mm</source>
        <translation>doku %1 mm yer değiştirdi; orada doğrusal dolu cisim %2 mm için geçerlidir</translation>
    </message>
    <message>
        <source>Press less deep or more slowly.</source>
        <translation>Daha az derine ya da daha yavaş bastırın.</translation>
    </message>
    <message>
        <source>Move more slowly. If it comes again, whoever made this organ has to make it more stable.</source>
        <translation>Daha yavaş hareket edin. Yine olursa bu organı hazırlayan onu daha kararlı yapmalıdır.</translation>
    </message>
    <message>
        <source>Press less deep or more slowly, or make the organ stiffer.</source>
        <translation>Daha az derine ya da daha yavaş bastırın ya da organı sertleştirin.</translation>
    </message>
    <message>
        <source>More substeps, softer springs, more damping or a larger mass hold it together.</source>
        <translation>Daha çok alt adım, daha yumuşak yaylar, daha çok sönüm ya da daha büyük kütle onu bir arada tutar.</translation>
    </message>
    <message>
        <source>Press less deep, or take a solid (MSS+V), which goes deeper.</source>
        <translation>Daha az derine bastırın ya da daha derine giden dolu cismi (MSS+V) seçin.</translation>
    </message>
</context>
</TS>
