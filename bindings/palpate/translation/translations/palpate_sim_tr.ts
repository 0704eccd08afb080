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
        <source>the tissue blew up: a point moved %1 mm between two checks, at most %2 mm is right</source>
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
        <source>Move more slowly. If it happens again, the designer of this organ has to make it more stable.</source>
        <translation>Daha yavaş hareket edin. Yine olursa bu organı hazırlayan onu daha kararlı yapmalıdır.</translation>
    </message>
    <message>
        <source>Press less deep or more slowly, or make the organ stiffer.</source>
        <translation>Daha az derine ya da daha yavaş bastırın ya da organı sertleştirin.</translation>
    </message>
    <message>
        <source>More substeps (%1), softer springs (%2) or a larger mass (%3) hold it together.</source>
        <translation>Daha çok alt adım (%1), daha yumuşak yaylar (%2) ya da daha büyük kütle (%3) onu bir arada tutar.</translation>
    </message>
    <message>
        <source>The tissue needs %1 substeps a tick, at most %2 are taken: choose more (%3), softer springs (%4, or %5 where the tissue gives them) or a larger mass (%6).</source>
        <translation>Doku her tikte %1 alt adım ister, en çok %2 atılır: daha çok alt adım (%3), daha yumuşak yaylar (%4, dokudan geliyorsa %5) ya da daha büyük kütle (%6) seçin.</translation>
    </message>
    <message>
        <source>The angles of the tissue need %1 substeps a tick, at most %2 are taken: choose more (%3) or softer angles (%4, %5).</source>
        <translation>Dokunun açıları her tikte %1 alt adım ister, en çok %2 atılır: daha çok alt adım (%3) ya da daha yumuşak açılar (%4, %5) seçin.</translation>
    </message>
    <message>
        <source>The home springs of the tissue need %1 substeps a tick, at most %2 are taken: choose more (%3) or softer ones (%4).</source>
        <translation>Dokunun yuva yayları her tikte %1 alt adım ister, en çok %2 atılır: daha çok alt adım (%3) ya da daha yumuşak yuva yayları (%4) seçin.</translation>
    </message>
    <message>
        <source>The tissue needs %1 substeps a tick, at most %2 are taken: choose more (%3), a softer tissue (%4, %5) or a larger mass (%6).</source>
        <translation>Doku her tikte %1 alt adım ister, en çok %2 atılır: daha çok alt adım (%3), daha yumuşak bir doku (%4, %5) ya da daha büyük kütle (%6) seçin.</translation>
    </message>
    <message>
        <source>Its damping needs %1 substeps a tick, at most %2 are taken: choose less damping (%3) or more substeps (%4).</source>
        <translation>Sönümü her tikte %1 alt adım ister, en çok %2 atılır: daha az sönüm (%3) ya da daha çok alt adım (%4) seçin.</translation>
    </message>
    <message>
        <source>Its drag needs %1 substeps a tick, at most %2 are taken: choose less drag (%3) or more substeps (%4).</source>
        <translation>Sürüklenmesi her tikte %1 alt adım ister, en çok %2 atılır: daha az sürüklenme (%3) ya da daha çok alt adım (%4) seçin.</translation>
    </message>
    <message>
        <source>A light touch does it with %1 substeps a tick, and does not with %2: choose more (%3).</source>
        <translation>Hafif bir dokunuş her tikte %1 alt adımla bunu yapıyor, %2 ile yapmıyor: daha çok alt adım (%3) seçin.</translation>
    </message>
    <message>
        <source>A light touch does it with a contact stiffness of %1 N/mm³, and does not with %2 N/mm³: choose a lower one (%3).</source>
        <translation>Hafif bir dokunuş %1 N/mm³ temas katılığıyla bunu yapıyor, %2 N/mm³ ile yapmıyor: daha düşük bir temas katılığı (%3) seçin.</translation>
    </message>
    <message>
        <source>A light pull does it with a grip stiffness of %1 N/m, and does not with %2 N/m: choose a lower one (%3).</source>
        <translation>Hafif bir çekiş %1 N/m tutma katılığıyla bunu yapıyor, %2 N/m ile yapmıyor: daha düşük bir tutma katılığı (%3) seçin.</translation>
    </message>
    <message>
        <source>Press less deep, or take a solid (MSS+V), which goes deeper.</source>
        <translation>Daha az derine bastırın ya da daha derine giden dolu cismi (MSS+V) seçin.</translation>
    </message>
    <message>
        <source>a tick was given a value that it cannot use</source>
        <translation>bir adıma kullanamayacağı bir değer verildi</translation>
    </message>
    <message>
        <source>Start again. If it comes again, the device or the program that runs it is at fault.</source>
        <translation>Yeniden başlatın. Yine olursa cihazda ya da onu çalıştıran programda hata vardır.</translation>
    </message>
    <message>
        <source>an implicit step of %1 ms found no balance of forces</source>
        <translation>%1 ms süren bir örtük adım kuvvet dengesi bulamadı</translation>
    </message>
    <message>
        <source>Press less deep or more slowly, or choose more substeps (%1) or another integrator.</source>
        <translation>Daha az derine ya da daha yavaş bastırın; ya da daha çok alt adım (%1) veya başka bir integral yöntemi seçin.</translation>
    </message>
    <message>
        <source>Give every tick finite numbers, and the scene as build_scene returned it.</source>
        <translation>Her adıma sonlu sayılar ve build_scene'in verdiği sahneyi verin.</translation>
    </message>
    <message>
        <source>the device gave a time of %1 s, expected a finite number</source>
        <translation>cihaz %1 s zaman verdi, sonlu bir sayı bekleniyordu</translation>
    </message>
    <message>
        <source>the device gave a position of %1 m, expected at most %2 m</source>
        <translation>cihaz %1 m konum verdi, en çok %2 m bekleniyordu</translation>
    </message>
    <message>
        <source>the device gave an orientation with %1, expected finite numbers</source>
        <translation>cihaz içinde %1 olan bir yönelim verdi, sonlu sayılar bekleniyordu</translation>
    </message>
    <message>
        <source>the device gave a velocity of %1 m/s, expected a finite number</source>
        <translation>cihaz %1 m/s hız verdi, sonlu bir sayı bekleniyordu</translation>
    </message>
    <message>
        <source>the device gave a grip of %1 rad, expected a finite number</source>
        <translation>cihaz %1 rad kavrama verdi, sonlu bir sayı bekleniyordu</translation>
    </message>
    <message>
        <source>a tick was asked to last %1 s, expected more than 0</source>
        <translation>bir adımın %1 s sürmesi istendi, 0'dan çok bekleniyordu</translation>
    </message>
    <message>
        <source>a tick was given scene %1, expected scene %2, which its world was made for</source>
        <translation>bir adıma %1. sahne verildi, dünyasının yapıldığı %2. sahne bekleniyordu</translation>
    </message>
    <message>
        <source>the friction of the tool became %1, expected at least 0</source>
        <translation>aletin sürtünmesi %1 oldu, en az 0 olmalı</translation>
    </message>
    <message>
        <source>the radius of the tool became %1 m, expected more than 0</source>
        <translation>aletin yarıçapı %1 m oldu, 0'dan büyük olmalı</translation>
    </message>
    <message>
        <source>the stiffness of the tool became %1 N/m³, expected more than 0</source>
        <translation>aletin sertliği %1 N/m³ oldu, 0'dan büyük olmalı</translation>
    </message>
    <message>
        <source>the coupling stiffness became %1 N/m, expected more than 0</source>
        <translation>bağlaşım sertliği %1 N/m oldu, 0'dan büyük olmalı</translation>
    </message>
    <message>
        <source>the largest coupling force became %1 N, expected more than 0</source>
        <translation>en büyük bağlaşım kuvveti %1 N oldu, 0'dan büyük olmalı</translation>
    </message>
    <message>
        <source>the hold stiffness became %1 N/m, expected more than 0</source>
        <translation>tutma sertliği %1 N/m oldu, 0'dan büyük olmalı</translation>
    </message>
    <message>
        <source>gravity became %1 m/s², expected a finite number</source>
        <translation>yerçekimi %1 m/s² oldu, sonlu bir sayı bekleniyordu</translation>
    </message>
    <message>
        <source>the substeps became %1, expected at least %2</source>
        <translation>alt adım sayısı %1 oldu, en az %2 olmalı</translation>
    </message>
    <message>
        <source>the most substeps became %1, expected at least %2</source>
        <translation>en çok alt adım sayısı %1 oldu, en az %2 olmalı</translation>
    </message>
    <message>
        <source>A pressure of %1 kPa does it with nothing touching, and one of %2 kPa does not: choose a lower one (%3), or stiffer springs (%4, %5).</source>
        <translation>%1 kPa basınç hiçbir şey değmeden bunu yapıyor, %2 kPa yapmıyor: daha düşük bir basınç (%3) ya da daha sert yaylar (%4, %5) seçin.</translation>
    </message>
    <message>
        <source>Angles of %1 N do it with nothing touching, for Eq 10 makes energy, and those of %2 N do not: choose another law of angles (%3) or softer angles (%4).</source>
        <translation>%1 N açılar hiçbir şey değmeden bunu yapıyor, çünkü Eşitlik 10 enerji üretir; %2 N yapmıyor: başka bir açı yasası (%3) ya da daha yumuşak açılar (%4) seçin.</translation>
    </message>
    <message>
        <source>The tissue was about to blow up, and is stepped twice as finely for now.</source>
        <translation>Doku patlamak üzereydi; şimdilik iki kat ince adımlarla hesaplanıyor.</translation>
    </message>
    <message>
        <source>The tissue was about to blow up, and is stepped four times as finely for now.</source>
        <translation>Doku patlamak üzereydi; şimdilik dört kat ince adımlarla hesaplanıyor.</translation>
    </message>
    <message>
        <source>The tissue was about to blow up, and is damped implicitly for now.</source>
        <translation>Doku patlamak üzereydi; şimdilik örtük olarak sönümleniyor.</translation>
    </message>
    <message>
        <source>The tissue was about to blow up, and its stiffest parts are solved for implicitly for now.</source>
        <translation>Doku patlamak üzereydi; en sert yerleri şimdilik örtük olarak çözülüyor.</translation>
    </message>
    <message>
        <source>It began at the point at %1, %2, %3 mm.</source>
        <translation>%1, %2, %3 mm konumundaki noktada başladı.</translation>
    </message>
    <message>
        <source>It began in the link at %1, %2, %3 mm.</source>
        <translation>%1, %2, %3 mm konumundaki bağda başladı.</translation>
    </message>
    <message>
        <source>It began in the tetrahedron at %1, %2, %3 mm.</source>
        <translation>%1, %2, %3 mm konumundaki dörtyüzlüde başladı.</translation>
    </message>
    <message>
        <source>It began at the point of the surface at %1, %2, %3 mm.</source>
        <translation>Yüzeyin %1, %2, %3 mm konumundaki noktasında başladı.</translation>
    </message>
</context>
<context>
    <name>Refusal</name>
    <message>
        <source>is %1 mm inside of %2: moved %3 mm, by %4 mm</source>
        <translation>%2 parçasının %1 mm içinde: %3 mm taşındı (%4 mm)</translation>
    </message>
    <message>
        <source>is %1 mm from %2, less than half the thickness: moved %3 mm, by %4 mm</source>
        <translation>%2 parçasına %1 mm uzakta, kalınlığın yarısından az: %3 mm taşındı (%4 mm)</translation>
    </message>
    <message>
        <source>is %1 mm inside of %2, expected no more than what moving it %3 mm parts: place it elsewhere</source>
        <translation>%2 parçasının %1 mm içinde; en çok %3 mm taşımakla ayrılabilmeli: başka bir yere yerleştirin</translation>
    </message>
    <message>
        <source>is %1 mm from %2, less than half the thickness, expected no more than what moving it %3 mm parts: place it elsewhere</source>
        <translation>%2 parçasına %1 mm uzakta, kalınlığın yarısından az; en çok %3 mm taşımakla ayrılabilmeli: başka bir yere yerleştirin</translation>
    </message>
    <message>
        <source>overlap by %1 mm and are no pair: they pass through each other</source>
        <translation>%1 mm iç içe ve bir çift değil: birbirinin içinden geçerler</translation>
    </message>
    <message>
        <source>its force_error of %1 N is 0 here: a body that others touch never sleeps</source>
        <translation>%1 N olan force_error burada 0: başkalarının dokunduğu bir cisim hiç uyumaz</translation>
    </message>
    <message>
        <source>are too far apart to be pressed together</source>
        <translation>birbirine bastırılamayacak kadar uzaktalar</translation>
    </message>
    <message>
        <source>did not touch when pressed towards each other: their cost is that of bodies apart</source>
        <translation>birbirine doğru bastırılınca değmediler: maliyetleri ayrı cisimlerinkidir</translation>
    </message>
    <message>
        <source>stops instruments and stones alone: `palpate scene pair LAYOUT %1 BODY` has it stop a body</source>
        <translation>yalnızca aletlere ve taşlara engeldir: `palpate scene pair LAYOUT %1 BODY` onu bir cisme de engel yapar</translation>
    </message>
    <message>
        <source>got none, expected one or more: add an organ</source>
        <translation>hiç yok, bir ya da daha çok olmalı: bir organ ekleyin</translation>
    </message>
    <message>
        <source>has no gravity, so stones float: `palpate scene set LAYOUT --gravity=0,0,-9.81` gives it one</source>
        <translation>yerçekimi yok, taşlar yüzer: `palpate scene set LAYOUT --gravity=0,0,-9.81` ona yerçekimi verir</translation>
    </message>
    <message>
        <source>went %1 mm through each other when pressed with %2: with %3 they do not</source>
        <translation>%2 ile bastırılınca birbirinin %1 mm içinden geçtiler: %3 ile geçmezler</translation>
    </message>
    <message>
        <source>pressed together with %1, and not with %2: %3</source>
        <translation>%1 ile birbirine bastırılınca, %2 ile değil: %3</translation>
    </message>
    <message>
        <source>a tick takes %1 us here when they are pressed together, expected at most %2 us: %3 asks for %4 substeps, %5 for %6</source>
        <translation>birbirine bastırılınca bir adım burada %1 us sürüyor, en çok %2 us olmalı: %3 %4 alt adım ister, %5 ise %6</translation>
    </message>
    <message>
        <source>went %1 mm through each other when pressed</source>
        <translation>bastırılınca birbirinin %1 mm içinden geçtiler</translation>
    </message>
    <message>
        <source>a tick takes %1 us here when they are pressed together, expected at most %2 us</source>
        <translation>birbirine bastırılınca bir adım burada %1 us sürüyor, en çok %2 us olmalı</translation>
    </message>
    <message>
        <source>%1 bytes after the last triangle were left alone</source>
        <translation>son üçgenden sonraki %1 bayt olduğu gibi bırakıldı</translation>
    </message>
    <message>
        <source>%1 cells fill it: their outer faces are the surface, and the organ is filled again</source>
        <translation>içini %1 hücre doldurur: dış yüzleri yüzeydir, organ yeniden doldurulur</translation>
    </message>
    <message>
        <source>%1 edges where the surface touched itself were parted</source>
        <translation>yüzeyin kendine değdiği %1 kenar ayrıldı</translation>
    </message>
    <message>
        <source>%1 edges with more than two triangles</source>
        <translation>ikiden çok üçgeni olan %1 kenar</translation>
    </message>
    <message>
        <source>%1 faces of fewer than three corners were left out</source>
        <translation>üçten az köşeli %1 yüz dışarıda bırakıldı</translation>
    </message>
    <message>
        <source>%1 free-form curves or surfaces were left out</source>
        <translation>%1 serbest biçimli eğri ya da yüzey dışarıda bırakıldı</translation>
    </message>
    <message>
        <source>%1 holes</source>
        <translation>%1 delik</translation>
    </message>
    <message>
        <source>%1 parts</source>
        <translation>%1 parça</translation>
    </message>
    <message>
        <source>%1 pieces smaller than a thousandth of it were dropped</source>
        <translation>binde birinden küçük %1 parça atıldı</translation>
    </message>
    <message>
        <source>%1 tetrahedra fill it, whose outer faces are the surface</source>
        <translation>içini %1 dörtyüzlü doldurur, dış yüzleri yüzeydir</translation>
    </message>
    <message>
        <source>%1 vertices were welded across parts, by up to %2 mm</source>
        <translation>parçalar arasında %1 köşe kaynaştırıldı, en çok %2 mm kayarak</translation>
    </message>
    <message>
        <source>%1 about one axis</source>
        <translation>bir eksende %1</translation>
    </message>
    <message>
        <source>%1 centres and %2 radii</source>
        <translation>%1 merkez ve %2 yarıçap</translation>
    </message>
    <message>
        <source>%1 vertices and %2 triangles with those before</source>
        <translation>öncekilerle birlikte %1 köşe ve %2 üçgen</translation>
    </message>
    <message>
        <source>%1.mesh: %2</source>
        <translation>%1.mesh: %2</translation>
    </message>
    <message>
        <source>0 beside rigid bodies: how wrong sleep makes a force is known of balls</source>
        <translation>rijit cisimlerin yanında 0: uykunun kuvveti ne kadar yanlış yaptığı bilyeler için bilinir</translation>
    </message>
    <message>
        <source>0 for a body that stops at scenery: how wrong sleep makes a force is known of balls</source>
        <translation>sabit çevrede duran bir cisim için 0: uykunun kuvveti ne kadar yanlış yaptığı bilyeler için bilinir</translation>
    </message>
    <message>
        <source>0 for a scene with rigid bodies: between two exchanges nothing but tissue is felt</source>
        <translation>rijit cisimleri olan bir sahne için 0: iki alışveriş arasında dokudan başka bir şey hissedilmez</translation>
    </message>
    <message>
        <source>0 for a scene with scenery: between two exchanges nothing but tissue is felt</source>
        <translation>sabit çevresi olan bir sahne için 0: iki alışveriş arasında dokudan başka bir şey hissedilmez</translation>
    </message>
    <message>
        <source>a closed mesh, which build_scene makes of the spheres where there is none</source>
        <translation>kapalı bir ağ; olmadığında build_scene onu kürelerden yapar</translation>
    </message>
    <message>
        <source>a closed mesh, whose volume is what the fluid bears</source>
        <translation>kapalı bir ağ; sıvı onun hacmini taşır</translation>
    </message>
    <message>
        <source>a closed one</source>
        <translation>kapalı bir ağ</translation>
    </message>
    <message>
        <source>a linear solid that touches more than instruments</source>
        <translation>aletlerden fazlasına değen bir doğrusal dolu cisim</translation>
    </message>
    <message>
        <source>a list of %1 numbers</source>
        <translation>%1 sayılık bir liste</translation>
    </message>
    <message>
        <source>a list of at most %1 whole numbers from 0 to %2</source>
        <translation>0 ile %2 arası en çok %1 tam sayıdan bir liste</translation>
    </message>
    <message>
        <source>a norm of %1</source>
        <translation>%1 büyüklük</translation>
    </message>
    <message>
        <source>a tissue of another law: a file's linear solids are solved by their response, which neither other bodies nor stones nor scenery can touch</source>
        <translation>başka yasadan bir doku: bir dosyanın doğrusal dolu cisimleri, başka cisimlerin, taşların ve sabit çevrenin değemeyeceği yanıtlarıyla çözülür</translation>
    </message>
    <message>
        <source>a unit quaternion</source>
        <translation>birim dördey</translation>
    </message>
    <message>
        <source>a volume of %1 m^3</source>
        <translation>%1 m³ hacim</translation>
    </message>
    <message>
        <source>an open one</source>
        <translation>açık bir ağ</translation>
    </message>
    <message>
        <source>as many of both, 1 to %1</source>
        <translation>ikisinden aynı sayıda, 1 ile %1 arası</translation>
    </message>
    <message>
        <source>at most %1 and %2 of all rigid bodies and scenery</source>
        <translation>tüm rijit cisimlerle sabit çevrede en çok %1 ve %2</translation>
    </message>
    <message>
        <source>at most %1, the sum about the others</source>
        <translation>en çok %1, öteki eksenlerdekilerin toplamı</translation>
    </message>
    <message>
        <source>bodies that begin outside of what stops them: move one of them, or hold what is fastened there</source>
        <translation>kendilerini durduranın dışında başlayan cisimler: birini kaydırın ya da oraya bağlı olanı sabitleyin</translation>
    </message>
    <message>
        <source>body %1 again</source>
        <translation>yeniden %1 numaralı cisim</translation>
    </message>
    <message>
        <source>each body once</source>
        <translation>her cisim bir kez</translation>
    </message>
    <message>
        <source>no number</source>
        <translation>sayı olmayan bir değer</translation>
    </message>
    <message>
        <source>none for several spheres in a fluid</source>
        <translation>bir sıvıdaki birkaç küre için hiç</translation>
    </message>
    <message>
        <source>none, which came with version %1</source>
        <translation>hiç; %1 numaralı sürümle geldi</translation>
    </message>
    <message>
        <source>one that begins outside: move the body</source>
        <translation>dışarıda başlayan bir cisim: cismi kaydırın</translation>
    </message>
    <message>
        <source>reference, or a tissue of another law, beside rigid bodies: contacts with them are not solved with a precomputed response</source>
        <translation>rijit cisimlerin yanında reference ya da başka yasadan bir doku: onlarla temaslar önceden hesaplanmış bir yanıtla çözülmez</translation>
    </message>
    <message>
        <source>reference, or a tissue of another law, for a body that stops at scenery: contacts with it are not solved with a precomputed response</source>
        <translation>sabit çevrede duran bir cisim için reference ya da başka yasadan bir doku: onunla temaslar önceden hesaplanmış bir yanıtla çözülmez</translation>
    </message>
    <message>
        <source>some of the %1 bodies, counted from 0</source>
        <translation>0'dan sayılan %1 cisimden bazıları</translation>
    </message>
    <message>
        <source>sphere %1 deep in body %2</source>
        <translation>%2 numaralı cismin içinde derinde %1 numaralı küre</translation>
    </message>
    <message>
        <source>sphere %1 deep in scenery %2</source>
        <translation>%2 numaralı sabit çevrenin içinde derinde %1 numaralı küre</translation>
    </message>
    <message>
        <source>triangles that run counter-clockwise seen from outside</source>
        <translation>dışarıdan bakınca saat yönünün tersine dönen üçgenler</translation>
    </message>
    <message>
        <source>vertex %1 of body %2 %3 mm inside of the scenery</source>
        <translation>%2 numaralı cismin %1 numaralı köşesi, sabit çevrenin %3 mm içinde</translation>
    </message>
    <message>
        <source>vertex %1 of the scenery %2 mm inside of body %3</source>
        <translation>sabit çevrenin %1 numaralı köşesi, %3 numaralı cismin %2 mm içinde</translation>
    </message>
    <message>
        <source>%1 mm from side to side</source>
        <translation>bir yandan öbürüne %1 mm</translation>
    </message>
    <message>
        <source>a scene of no file</source>
        <translation>dosyası olmayan bir sahne</translation>
    </message>
    <message>
        <source>one: what is in it is named from there</source>
        <translation>bir dosya: içindekiler oradan adlandırılır</translation>
    </message>
    <message>
        <source>%1 m from side to side</source>
        <translation>bir yandan öbürüne %1 m</translation>
    </message>
    <message>
        <source>3, or none</source>
        <translation>3 ya da hiç</translation>
    </message>
    <message>
        <source>a closed one, as a stone has</source>
        <translation>taşlarınki gibi kapalı bir yüzey</translation>
    </message>
    <message>
        <source>a mesh with no room for spheres</source>
        <translation>içine küre sığmayan bir ağ</translation>
    </message>
    <message>
        <source>a volume of %1 mm³</source>
        <translation>%1 mm³ hacim</translation>
    </message>
    <message>
        <source>an open surface</source>
        <translation>açık bir yüzey</translation>
    </message>
    <message>
        <source>names of bodies, each once</source>
        <translation>cisimlerin adları, her biri bir kez</translation>
    </message>
    <message>
        <source>one with an inside</source>
        <translation>içi olan bir ağ</translation>
    </message>
    <message>
        <source>%1 mm or more; a file in metres is added with --unit m</source>
        <translation>%1 mm ya da daha çok; metre cinsinden bir dosya --unit m ile eklenir</translation>
    </message>
    <message>
        <source>up to %1 m; a file in millimetres is added with --unit mm</source>
        <translation>en çok %1 m; milimetre cinsinden bir dosya --unit mm ile eklenir</translation>
    </message>
    <message>
        <source>%1, one more for each body that may fold</source>
        <translation>%1; katlanabilen her cisim için bir fazlası</translation>
    </message>
    <message>
        <source>0 for a body of body_pairs: how wrong sleep makes a force is known of balls</source>
        <translation>body_pairs içindeki bir cisim için 0: uykunun kuvveti ne kadar yanlış yaptığı bilyeler için bilinir</translation>
    </message>
    <message>
        <source>0 for a scene with body_pairs: between two exchanges bodies do not touch each other</source>
        <translation>body_pairs olan bir sahne için 0: iki alışveriş arasında cisimler birbirine değmez</translation>
    </message>
    <message>
        <source>0 to have it chosen, or a positive number</source>
        <translation>seçilmesi için 0 ya da artı bir sayı</translation>
    </message>
    <message>
        <source>0 to have it chosen, or up to 0.005</source>
        <translation>seçilmesi için 0 ya da en çok 0,005</translation>
    </message>
    <message>
        <source>1 hole</source>
        <translation>1 delik</translation>
    </message>
    <message>
        <source>a closed part that does not cross itself: repair it, leave it out, or weld the parts of one surface without uniting them</source>
        <translation>kendini kesmeyen kapalı bir parça: onarın, dışarıda bırakın, ya da tek bir yüzeyin parçalarını birleştirmeden kaynaştırın</translation>
    </message>
    <message>
        <source>a closed surface without crossings: parts that nearly touch are welded instead</source>
        <translation>kendini kesmeyen kapalı bir yüzey: neredeyse değen parçalar bunun yerine kaynaştırılır</translation>
    </message>
    <message>
        <source>a linear solid under its response</source>
        <translation>yanıtıyla çözülen bir doğrusal dolu cisim</translation>
    </message>
    <message>
        <source>a list of 2 whole numbers from 0 to %1</source>
        <translation>0 ile %1 arası 2 tam sayıdan bir liste</translation>
    </message>
    <message>
        <source>a name of 1 to %1 bytes</source>
        <translation>1 ile %1 bayt arası bir ad</translation>
    </message>
    <message>
        <source>a part named %1</source>
        <translation>%1 adlı bir parça</translation>
    </message>
    <message>
        <source>a positive number for tissues without a modulus of their own</source>
        <translation>kendi modülü olmayan dokular için artı bir sayı</translation>
    </message>
    <message>
        <source>a solid</source>
        <translation>bir katı cisim</translation>
    </message>
    <message>
        <source>a surface with one side only</source>
        <translation>tek yüzlü bir yüzey</translation>
    </message>
    <message>
        <source>at least %1 mm between them at rest, half of the thickness: move one of them</source>
        <translation>durgunken aralarında en az %1 mm, kalınlığın yarısı: birini kaydırın</translation>
    </message>
    <message>
        <source>at least one that they are taken from</source>
        <translation>çıkarılacakları en az bir parça</translation>
    </message>
    <message>
        <source>at most %1: choose fewer</source>
        <translation>en çok %1: daha azını seçin</translation>
    </message>
    <message>
        <source>bodies %1 and %2 again</source>
        <translation>yeniden %1 ve %2 numaralı cisimler</translation>
    </message>
    <message>
        <source>body %1</source>
        <translation>%1 numaralı cisim</translation>
    </message>
    <message>
        <source>body %1 with itself</source>
        <translation>%1 numaralı cismin kendisiyle çifti</translation>
    </message>
    <message>
        <source>did not open %1, which lies outside of its folder</source>
        <translation>klasörünün dışında kalan %1 açılmadı</translation>
    </message>
    <message>
        <source>each pair once</source>
        <translation>her çiftten bir tane</translation>
    </message>
    <message>
        <source>faces at %1 degrees to each other, where %2 are needed</source>
        <translation>yüzleri arasında %1 derece var, %2 derece gerekir</translation>
    </message>
    <message>
        <source>its tetrahedra are not used, and the organ is filled again: %1</source>
        <translation>dörtyüzlüleri kullanılmaz, organ yeniden doldurulur: %1</translation>
    </message>
    <message>
        <source>its tetrahedra fill the organ, the smallest angle between faces is %1 degrees</source>
        <translation>organı kendi dörtyüzlüleri doldurur, yüzler arasındaki en küçük açı %1 derecedir</translation>
    </message>
    <message>
        <source>nothing that is left of the parts</source>
        <translation>parçalardan geriye hiçbir şey kalmaması</translation>
    </message>
    <message>
        <source>one in a file of version %1</source>
        <translation>%1 sürümündeki bir dosyada bir tane</translation>
    </message>
    <message>
        <source>one of the %1 bodies, counted from 0</source>
        <translation>0'dan sayılan %1 cisimden biri</translation>
    </message>
    <message>
        <source>parts that are all taken away</source>
        <translation>hepsi çıkarılan parçalar</translation>
    </message>
    <message>
        <source>parts that cross or are apart: weld those that only touch</source>
        <translation>kesişen ya da ayrı duran parçalar: yalnızca değenleri kaynaştırın</translation>
    </message>
    <message>
        <source>parts that touch along an edge or in a vertex without crossing there</source>
        <translation>kesişmeden bir kenarda ya da köşede değen parçalar</translation>
    </message>
    <message>
        <source>reference, or a tissue of another law, for a body of body_pairs: contacts with other bodies are not solved with a precomputed response</source>
        <translation>body_pairs içindeki bir cisim için reference ya da başka yasadan bir doku: başka cisimlerle temaslar önceden hesaplanmış bir yanıtla çözülmez</translation>
    </message>
    <message>
        <source>shells that are apart, or cross</source>
        <translation>ayrı duran ya da kesişen kabuklar</translation>
    </message>
    <message>
        <source>shells that touch along an edge or in a vertex</source>
        <translation>bir kenarda ya da köşede değen kabuklar</translation>
    </message>
    <message>
        <source>states a unit of '%1', which has no name here</source>
        <translation>burada adı olmayan bir birim bildiriyor: '%1'</translation>
    </message>
    <message>
        <source>its faces count vertices from 0 and were read so</source>
        <translation>yüzleri köşeleri 0'dan sayıyor ve öyle okundu</translation>
    </message>
    <message>
        <source>states a unit of %1 cm, which has no name here</source>
        <translation>%1 cm uzunluğunda bir birim bildirir, bunun burada adı yok</translation>
    </message>
    <message>
        <source>its colours come along, one for each vertex</source>
        <translation>renkleri de geliyor, her köşe için bir tane</translation>
    </message>
    <message>
        <source>its colours come along, one for each vertex, of its picture</source>
        <translation>renkleri de geliyor, her köşe için bir tane, resminden</translation>
    </message>
    <message>
        <source>its colours come along, one for each vertex, of its %1 pictures</source>
        <translation>renkleri de geliyor, her köşe için bir tane, %1 resminden</translation>
    </message>
    <message>
        <source>the picture %1 is not beside it or below its folder</source>
        <translation>%1 resmi yanında ya da klasörünün altında değil</translation>
    </message>
    <message>
        <source>the picture %1 stays behind: %2</source>
        <translation>%1 resmi geride kalıyor: %2</translation>
    </message>
    <message>
        <source>the picture %1 is too large: at most 150 MB of them are taken</source>
        <translation>%1 resmi çok büyük: en çok 150 MB alınır</translation>
    </message>
    <message>
        <source>pictures of PLY files stay behind</source>
        <translation>PLY dosyalarının resimleri geride kalır</translation>
    </message>
    <message>
        <source>the colours of its vertices stay behind: a binary OFF&apos;s are not read</source>
        <translation>köşelerinin renkleri gelmez: ikili OFF dosyalarınınki okunmaz</translation>
    </message>
    <message>
        <source>the gantry was tilted by %1 degrees</source>
        <translation>gantri %1 derece eğikti</translation>
    </message>
    <message>
        <source>the materials in %1 are not there to be read</source>
        <translation>%1 içindeki malzemeler okunacak yerde değil</translation>
    </message>
    <message>
        <source>the surface is no longer their outside</source>
        <translation>yüzey artık onların dışı değil</translation>
    </message>
    <message>
        <source>there are %1, and an organ has %2 to %3</source>
        <translation>%1 tane var, bir organda %2 ile %3 arası olur</translation>
    </message>
    <message>
        <source>two bodies, or one that may_fold</source>
        <translation>iki cisim ya da katlanabilen (may_fold) bir cisim</translation>
    </message>
    <message>
        <source>united parts with %1</source>
        <translation>%1 bulunan birleşik parçalar</translation>
    </message>
    <message>
        <source>vertex %1 of body %2 %3 mm from body %4</source>
        <translation>%2 numaralı cismin %1 numaralı köşesi, %4 numaralı cismin %3 mm uzağında</translation>
    </message>
    <message>
        <source>vertex %1 of body %2 %3 mm inside of body %4</source>
        <translation>%2 numaralı cismin %1 numaralı köşesi, %4 numaralı cismin %3 mm içinde</translation>
    </message>
    <message>
        <source>voxels of %1 mm are not those of a clinical scan: is the unit another?</source>
        <translation>%1 mm vokseller klinik bir taramanınki değil: birim başka mı?</translation>
    </message>
    <message>
        <source>weld has no effect on parts that are united or subtracted: give one of them</source>
        <translation>birleştirilen ya da çıkarılan parçalarda kaynağın etkisi yok: ikisinden birini verin</translation>
    </message>
    <message>
        <source>weld must be a length that is not negative, got %1 m</source>
        <translation>kaynak, eksi olmayan bir uzunluk olmalı, verilen %1 m</translation>
    </message>
    <message>
        <source>the organ ends where the scan does at the left, and is closed there flat</source>
        <translation>organ solda taramanın bittiği yerde biter ve orada düz kapatılır</translation>
    </message>
    <message>
        <source>the organ ends where the scan does at the right, and is closed there flat</source>
        <translation>organ sağda taramanın bittiği yerde biter ve orada düz kapatılır</translation>
    </message>
    <message>
        <source>the organ ends where the scan does at the front, and is closed there flat</source>
        <translation>organ önde taramanın bittiği yerde biter ve orada düz kapatılır</translation>
    </message>
    <message>
        <source>the organ ends where the scan does at the back, and is closed there flat</source>
        <translation>organ arkada taramanın bittiği yerde biter ve orada düz kapatılır</translation>
    </message>
    <message>
        <source>the organ ends where the scan does at the bottom, and is closed there flat</source>
        <translation>organ altta taramanın bittiği yerde biter ve orada düz kapatılır</translation>
    </message>
    <message>
        <source>the organ ends where the scan does at the top, and is closed there flat</source>
        <translation>organ üstte taramanın bittiği yerde biter ve orada düz kapatılır</translation>
    </message>
    <message>
        <source>0 for an integrator other than symplectic_euler: parts of a tissue sleep in vector code only</source>
        <translation>symplectic_euler dışındaki bir integral yöntemi için 0: dokunun parçaları yalnızca vektör kodunda uyur</translation>
    </message>
    <message>
        <source>0 with %1: only xpbd and projective_dynamics have a number of them</source>
        <translation>%1 ile 0: yalnızca xpbd ve projective_dynamics için böyle bir sayı vardır</translation>
    </message>
    <message>
        <source>a ratio of 0: tetrahedra at finite strain do not relax</source>
        <translation>0 oranı: sonlu gerinimdeki dörtyüzlüler gevşemez</translation>
    </message>
    <message>
        <source>an implicit one</source>
        <translation>örtük olan biri</translation>
    </message>
    <message>
        <source>another for angles of eq10: xpbd and projective_dynamics lower an energy, and these have none</source>
        <translation>eq10 açıları için başka biri: xpbd ve projective_dynamics bir enerjiyi düşürür, bunlarınsa enerjisi yoktur</translation>
    </message>
    <message>
        <source>automatic or reference with the integrator %1: the others step by symplectic_euler</source>
        <translation>%1 integral yöntemiyle automatic ya da reference: ötekiler symplectic_euler ile ilerler</translation>
    </message>
    <message>
        <source>maxwell beside it</source>
        <translation>yanında maxwell</translation>
    </message>
    <message>
        <source>one that is stable where next to nothing is damped, as symplectic_euler: this needs %1 substeps per tick, of 10000</source>
        <translation>neredeyse hiçbir şeyin sönümlenmediği yerde kararlı olan biri, örneğin symplectic_euler: bunun her adımda 10000 yerine %1 alt adıma gereksinimi var</translation>
    </message>
    <message>
        <source>%1 MB for %2 particles under pushes on %3</source>
        <translation>%3 parçacığa bastırırken %2 parçacık için %1 MB</translation>
    </message>
    <message>
        <source>%1 N/m outside of every triangle</source>
        <translation>hiçbir üçgene ait olmayan %1 N/m</translation>
    </message>
    <message>
        <source>%1 N/m, the sum of its triangles' shares, once</source>
        <translation>üçgenlerinin paylarının toplamı olan %1 N/m, bir kez</translation>
    </message>
    <message>
        <source>%1 Pa on a skin</source>
        <translation>bir deri üzerinde %1 Pa</translation>
    </message>
    <message>
        <source>%1 after %2</source>
        <translation>%2 ardından %1</translation>
    </message>
    <message>
        <source>%1 arrays</source>
        <translation>%1 dizi</translation>
    </message>
    <message>
        <source>%1 beside it</source>
        <translation>yanında %1</translation>
    </message>
    <message>
        <source>%1 bytes</source>
        <translation>%1 bayt</translation>
    </message>
    <message>
        <source>%1 bytes of text</source>
        <translation>%1 baytlık metin</translation>
    </message>
    <message>
        <source>%1 corners</source>
        <translation>%1 köşe</translation>
    </message>
    <message>
        <source>%1 entries</source>
        <translation>%1 girdi</translation>
    </message>
    <message>
        <source>%1 for its %2 triangles</source>
        <translation>%2 üçgeni için %1</translation>
    </message>
    <message>
        <source>%1 hand samples and %2 felt ones</source>
        <translation>%1 el örneği ve %2 hissedilen örnek</translation>
    </message>
    <message>
        <source>%1 languages</source>
        <translation>%1 dil</translation>
    </message>
    <message>
        <source>%1 mm, at which nothing is filled</source>
        <translation>%1 mm; bu boyda hiçbir yer dolmaz</translation>
    </message>
    <message>
        <source>%1 mm, which gives about %2 tetrahedra</source>
        <translation>%1 mm; yaklaşık %2 dörtyüzlü verir</translation>
    </message>
    <message>
        <source>%1 numbers</source>
        <translation>%1 sayı</translation>
    </message>
    <message>
        <source>%1 of shape %2</source>
        <translation>%2 biçiminde %1</translation>
    </message>
    <message>
        <source>%1 of shape (%2)</source>
        <translation>(%2) biçiminde %1</translation>
    </message>
    <message>
        <source>%1 on this mesh</source>
        <translation>bu ağda %1</translation>
    </message>
    <message>
        <source>%1 or another type</source>
        <translation>%1 ya da başka bir tür</translation>
    </message>
    <message>
        <source>%1 or more</source>
        <translation>%1 ya da daha çok</translation>
    </message>
    <message>
        <source>%1 or none</source>
        <translation>%1 ya da hiç</translation>
    </message>
    <message>
        <source>%1 or older; the file was made by a newer program, which is needed to open it</source>
        <translation>%1 ya da daha eskisi; dosyayı daha yeni bir program yazmış, açmak için o gerekir</translation>
    </message>
    <message>
        <source>%1 rows</source>
        <translation>%1 satır</translation>
    </message>
    <message>
        <source>%1 to %2</source>
        <translation>%1 ile %2 arası</translation>
    </message>
    <message>
        <source>%1 to %2 %3</source>
        <translation>%1 ile %2 arası, %3</translation>
    </message>
    <message>
        <source>%1 to %2 N</source>
        <translation>%1 ile %2 N arası</translation>
    </message>
    <message>
        <source>%1 to %2 for a solid</source>
        <translation>dolu cisim için %1 ile %2 arası</translation>
    </message>
    <message>
        <source>%1 triangles that cross others</source>
        <translation>başkalarıyla kesişen %1 üçgen</translation>
    </message>
    <message>
        <source>%1 units from corner to corner</source>
        <translation>köşeden köşeye %1 birim</translation>
    </message>
    <message>
        <source>%1 with another SHA-256</source>
        <translation>SHA-256 değeri başka olan %1</translation>
    </message>
    <message>
        <source>%1, one per triangle</source>
        <translation>%1, her üçgene bir tane</translation>
    </message>
    <message>
        <source>%1, which its shape needs</source>
        <translation>biçiminin gerektirdiği %1</translation>
    </message>
    <message>
        <source>%1, which the rest lengths give</source>
        <translation>durgun boyların verdiği %1</translation>
    </message>
    <message>
        <source>%1, which the tissue gives</source>
        <translation>dokunun verdiği %1</translation>
    </message>
    <message>
        <source>%1..., as the manifest says</source>
        <translation>manifest'in söylediği %1...</translation>
    </message>
    <message>
        <source>%1: %2, expected a serial port that takes %3 bit/s</source>
        <translation>%1: %2; beklenen: %3 bit/s hızını alan bir seri kapı</translation>
    </message>
    <message>
        <source>%1: 1 to 60, so centimetres</source>
        <translation>%1: 1 ile 60 arası, demek ki santimetre</translation>
    </message>
    <message>
        <source>%1: above 60, so millimetres</source>
        <translation>%1: 60'ın üstünde, demek ki milimetre</translation>
    </message>
    <message>
        <source>%1: below 1, so metres</source>
        <translation>%1: 1'in altında, demek ki metre</translation>
    </message>
    <message>
        <source>%1: did not take the calibration: %2</source>
        <translation>%1: kalibrasyonu kabul etmedi: %2</translation>
    </message>
    <message>
        <source>%1: extension must be .obj or .stl, got '%2'</source>
        <translation>%1: uzantı .obj ya da .stl olmalı, verilen '%2'</translation>
    </message>
    <message>
        <source>%1: got %2, expected %3</source>
        <translation>%1: bulunan: %2; beklenen: %3</translation>
    </message>
    <message>
        <source>%1: has no calibration</source>
        <translation>%1: kalibrasyonu yok</translation>
    </message>
    <message>
        <source>%1: not a plain file</source>
        <translation>%1: düz bir dosya değil</translation>
    </message>
    <message>
        <source>%1: the lock of recovery cannot be had</source>
        <translation>%1: kurtarma kilidi alınamadı</translation>
    </message>
    <message>
        <source>.organ, .palpate or .scene.json; foreign meshes come in by `palpate import`</source>
        <translation>.organ, .palpate ya da .scene.json; başka ağlar `palpate import` ile alınır</translation>
    </message>
    <message>
        <source>0 bytes</source>
        <translation>0 bayt</translation>
    </message>
    <message>
        <source>0 or a positive number</source>
        <translation>0 ya da artı bir sayı</translation>
    </message>
    <message>
        <source>0 or a positive number, or larger bond shares beside it</source>
        <translation>0 ya da artı bir sayı ya da yanında daha büyük bağ payları</translation>
    </message>
    <message>
        <source>0 to %1</source>
        <translation>0 ile %1 arası</translation>
    </message>
    <message>
        <source>0 to 1</source>
        <translation>0 ile 1 arası</translation>
    </message>
    <message>
        <source>0 under AngleLaw::eq10, which has no stretch-bend force</source>
        <translation>AngleLaw::eq10 altında 0; onda gerilme-eğilme kuvveti yoktur</translation>
    </message>
    <message>
        <source>0 under AngleLaw::eq10, whose constants follow from the material</source>
        <translation>AngleLaw::eq10 altında 0; sabitleri malzemeden çıkar</translation>
    </message>
    <message>
        <source>0, or a small part of the forces to be felt</source>
        <translation>0 ya da hissedilecek kuvvetlerin küçük bir bölümü</translation>
    </message>
    <message>
        <source>0, or from substeps to 10000</source>
        <translation>0 ya da substeps ile 10000 arası</translation>
    </message>
    <message>
        <source>0, or home springs everywhere: without them a push is felt at any distance</source>
        <translation>0 ya da her yerde yuva yayları: onlarsız bir itiş her uzaklıkta duyulur</translation>
    </message>
    <message>
        <source>0: a solid has no inside for a pressure</source>
        <translation>0: dolu cismin basınç için bir içi yoktur</translation>
    </message>
    <message>
        <source>0: it costs what is touched, so there is nothing to let sleep</source>
        <translation>0: yalnızca dokunulan yer hesaplanır, uyutulacak bir şey yoktur</translation>
    </message>
    <message>
        <source>0: solids are moved whole, for they have no home springs, and without those a push is felt with one over its distance</source>
        <translation>0: dolu cisimler bütün olarak hareket ettirilir; yuva yayları yoktur ve onlarsız bir itiş uzaklıkla ters orantılı duyulur</translation>
    </message>
    <message>
        <source>0: walls of prisms are moved whole, for what may sleep follows from how far springs carry a pull, which is not how far a wall bends</source>
        <translation>0: prizmalı duvarlar bütün olarak hareket ettirilir; neyin uyuyabileceği yayların bir çekişi ne kadar uzağa taşıdığından çıkar, duvarın ne kadar uzağa eğildiğinden değil</translation>
    </message>
    <message>
        <source>1 and up, or -1 to -%1 counting back</source>
        <translation>1 ve üstü ya da geriye sayarak -1 ile -%1 arası</translation>
    </message>
    <message>
        <source>1 to %1</source>
        <translation>1 ile %1 arası</translation>
    </message>
    <message>
        <source>3 in each facet</source>
        <translation>her yüzde 3</translation>
    </message>
    <message>
        <source>64 hexadecimal digits</source>
        <translation>64 onaltılık basamak</translation>
    </message>
    <message>
        <source>Device or resource busy</source>
        <translation>aygıt başkası tarafından kullanılıyor</translation>
    </message>
    <message>
        <source>File exists</source>
        <translation>dosya zaten var</translation>
    </message>
    <message>
        <source>Inappropriate ioctl for device</source>
        <translation>bu bir seri kapı değil</translation>
    </message>
    <message>
        <source>Input/output error</source>
        <translation>giriş/çıkış hatası</translation>
    </message>
    <message>
        <source>Is a directory</source>
        <translation>bu bir klasör</translation>
    </message>
    <message>
        <source>K_btheta %1 N and a tangent at rest with an eigenvalue of %2 N/m</source>
        <translation>K_btheta %1 N ve durgunken özdeğeri %2 N/m olan bir teğet</translation>
    </message>
    <message>
        <source>K_btheta %1 N, which makes its tangent at rest indefinite</source>
        <translation>durgun teğetini belirsiz yapan K_btheta %1 N</translation>
    </message>
    <message>
        <source>No space left on device</source>
        <translation>diskte yer kalmadı</translation>
    </message>
    <message>
        <source>No such device</source>
        <translation>böyle bir aygıt yok</translation>
    </message>
    <message>
        <source>No such file or directory</source>
        <translation>böyle bir dosya ya da klasör yok</translation>
    </message>
    <message>
        <source>Not a directory</source>
        <translation>bu bir klasör değil</translation>
    </message>
    <message>
        <source>Permission denied</source>
        <translation>izin yok</translation>
    </message>
    <message>
        <source>Read-only file system</source>
        <translation>salt okunur dosya sistemi</translation>
    </message>
    <message>
        <source>a body that can move without being strained</source>
        <translation>şekil değiştirmeden hareket edebilen bir cisim</translation>
    </message>
    <message>
        <source>a clean surface: `palpate import` repairs it</source>
        <translation>temiz bir yüzey: `palpate import` onarır</translation>
    </message>
    <message>
        <source>a closed one: nothing says how far the inside of an open one goes</source>
        <translation>kapalı bir yüzey: açık olanın içinin nereye kadar gittiğini hiçbir şey söylemez</translation>
    </message>
    <message>
        <source>a code such as tr or pt-BR</source>
        <translation>tr ya da pt-BR gibi bir kod</translation>
    </message>
    <message>
        <source>a coordinate that is not a finite number</source>
        <translation>sonlu bir sayı olmayan bir koordinat</translation>
    </message>
    <message>
        <source>a corner: i, i/t, i//n or i/t/n</source>
        <translation>bir köşe: i, i/t, i//n ya da i/t/n</translation>
    </message>
    <message>
        <source>a damaged entry</source>
        <translation>bozuk bir girdi</translation>
    </message>
    <message>
        <source>a damaged zip archive (%1)</source>
        <translation>bozuk bir zip arşivi (%1)</translation>
    </message>
    <message>
        <source>a directory of too many entries</source>
        <translation>çok fazla girdisi olan bir dizin</translation>
    </message>
    <message>
        <source>a disk that takes what was written</source>
        <translation>yazılanı alan bir disk</translation>
    </message>
    <message>
        <source>a face that two others have</source>
        <translation>iki başka dörtyüzlünün de paylaştığı bir yüz</translation>
    </message>
    <message>
        <source>a field of this name</source>
        <translation>bu adda bir alan</translation>
    </message>
    <message>
        <source>a file</source>
        <translation>bir dosya</translation>
    </message>
    <message>
        <source>a file of more bytes</source>
        <translation>daha çok baytlık bir dosya</translation>
    </message>
    <message>
        <source>a file that `palpate publish` wrote</source>
        <translation>`palpate publish` komutunun yazdığı bir dosya</translation>
    </message>
    <message>
        <source>a file that can be opened</source>
        <translation>açılabilen bir dosya</translation>
    </message>
    <message>
        <source>a file that can be written</source>
        <translation>yazılabilen bir dosya</translation>
    </message>
    <message>
        <source>a file that cannot be read</source>
        <translation>okunamayan bir dosya</translation>
    </message>
    <message>
        <source>a file that grows while it is read</source>
        <translation>okunurken büyüyen bir dosya</translation>
    </message>
    <message>
        <source>a file that shrinks while it is read</source>
        <translation>okunurken küçülen bir dosya</translation>
    </message>
    <message>
        <source>a finite number</source>
        <translation>sonlu bir sayı</translation>
    </message>
    <message>
        <source>a finite number or null</source>
        <translation>sonlu bir sayı ya da null</translation>
    </message>
    <message>
        <source>a folder in which every new file is taken away</source>
        <translation>her yeni dosyanın alınıp götürüldüğü bir klasör</translation>
    </message>
    <message>
        <source>a folder that the disk does not sync (%1)</source>
        <translation>diskin eşitlemediği bir klasör (%1)</translation>
    </message>
    <message>
        <source>a folder that the disk syncs</source>
        <translation>diskin eşitlediği bir klasör</translation>
    </message>
    <message>
        <source>a larger K_theta or K_b</source>
        <translation>daha büyük bir K_theta ya da K_b</translation>
    </message>
    <message>
        <source>a law of surfaces: a scene file has no tetrahedra; palpate-editor fills an organ and publishes it with them</source>
        <translation>yüzeyler için bir yasa: sahne dosyasında dörtyüzlü yoktur; palpate-editor organı doldurur ve onlarla yayımlar</translation>
    </message>
    <message>
        <source>a linear solid</source>
        <translation>doğrusal dolu cisim</translation>
    </message>
    <message>
        <source>a linear solid without its response</source>
        <translation>yanıtı olmayan bir doğrusal dolu cisim</translation>
    </message>
    <message>
        <source>a linear solid, as build_linear_solid makes it</source>
        <translation>build_linear_solid'in yaptığı gibi bir doğrusal dolu cisim</translation>
    </message>
    <message>
        <source>a link or a folder</source>
        <translation>bir bağlantı ya da klasör</translation>
    </message>
    <message>
        <source>a list of %1</source>
        <translation>%1 öğelik bir liste</translation>
    </message>
    <message>
        <source>a list of 1 to %1 whole numbers</source>
        <translation>1 ile %1 arası tam sayıdan bir liste</translation>
    </message>
    <message>
        <source>a list of at most %1</source>
        <translation>en çok %1 öğelik bir liste</translation>
    </message>
    <message>
        <source>a list of finite numbers</source>
        <translation>sonlu sayılardan bir liste</translation>
    </message>
    <message>
        <source>a list of text</source>
        <translation>metinlerden bir liste</translation>
    </message>
    <message>
        <source>a list of whole numbers</source>
        <translation>tam sayılardan bir liste</translation>
    </message>
    <message>
        <source>a manifold surface</source>
        <translation>çokkatlı (manifold) bir yüzey</translation>
    </message>
    <message>
        <source>a mesh file</source>
        <translation>bir ağ dosyası</translation>
    </message>
    <message>
        <source>a mesh file: .obj .stl .ply .off .glb .gltf .3ds .fbx .dae .x3d .3mf .amf .ac .x .lwo .vtk .vtp .vtu .vts .vtm .xdmf .xmf .neu .cas .msh .mesh .meshb .vol .veg .node .ele .face .smesh .poly .pts .elem .inp .unv .feb .bdf .nas .fem .k .key .dyn .gii .mz3 .wrl .wrz .iv .pial .white .inflated .orig .smoothwm</source>
        <translation>bir ağ dosyası: .obj .stl .ply .off .glb .gltf .3ds .fbx .dae .x3d .3mf .amf .ac .x .lwo .vtk .vtp .vtu .vts .vtm .xdmf .xmf .neu .cas .msh .mesh .meshb .vol .veg .node .ele .face .smesh .poly .pts .elem .inp .unv .feb .bdf .nas .fem .k .key .dyn .gii .mz3 .wrl .wrz .iv .pial .white .inflated .orig .smoothwm</translation>
    </message>
    <message>
        <source>a mesh file it can read whole</source>
        <translation>bütünüyle okunabilen bir ağ dosyası</translation>
    </message>
    <message>
        <source>a mesh that can be read in that time</source>
        <translation>bu sürede okunabilen bir ağ</translation>
    </message>
    <message>
        <source>a micrometre or more</source>
        <translation>bir mikrometre ya da daha çok</translation>
    </message>
    <message>
        <source>a model of build_linear_solid</source>
        <translation>build_linear_solid'in bir modeli</translation>
    </message>
    <message>
        <source>a name ending in %1</source>
        <translation>%1 ile biten bir ad</translation>
    </message>
    <message>
        <source>a name that no file can have</source>
        <translation>hiçbir dosyanın taşıyamayacağı bir ad</translation>
    </message>
    <message>
        <source>a name twice</source>
        <translation>iki kez aynı ad</translation>
    </message>
    <message>
        <source>a number</source>
        <translation>bir sayı</translation>
    </message>
    <message>
        <source>a number that is not finite</source>
        <translation>sonlu olmayan bir sayı</translation>
    </message>
    <message>
        <source>a number too large for a float of 8 bytes</source>
        <translation>8 baytlık kayan noktaya sığmayan bir sayı</translation>
    </message>
    <message>
        <source>a plain file</source>
        <translation>sıradan bir dosya</translation>
    </message>
    <message>
        <source>a plain one</source>
        <translation>şifresiz bir girdi</translation>
    </message>
    <message>
        <source>a positive length</source>
        <translation>artı bir uzunluk</translation>
    </message>
    <message>
        <source>a positive number</source>
        <translation>artı bir sayı</translation>
    </message>
    <message>
        <source>a positive number, or none for a solid</source>
        <translation>artı bir sayı ya da dolu cisim için hiç</translation>
    </message>
    <message>
        <source>a positive one</source>
        <translation>artı bir değer</translation>
    </message>
    <message>
        <source>a positive one: triangles counter-clockwise from outside</source>
        <translation>artı bir değer: dışarıdan bakınca üçgenler saat yönünün tersine</translation>
    </message>
    <message>
        <source>a pressure</source>
        <translation>basınç</translation>
    </message>
    <message>
        <source>a published value</source>
        <translation>yayımlanmış bir değer</translation>
    </message>
    <message>
        <source>a readable %1 file</source>
        <translation>okunabilir bir %1 dosyası</translation>
    </message>
    <message>
        <source>a readable STL file</source>
        <translation>okunabilir bir STL dosyası</translation>
    </message>
    <message>
        <source>a readable file</source>
        <translation>okunabilen bir dosya</translation>
    </message>
    <message>
        <source>a readable mesh file</source>
        <translation>okunabilir bir ağ dosyası</translation>
    </message>
    <message>
        <source>a reader that ended with code %1</source>
        <translation>%1 koduyla biten bir okuyucu</translation>
    </message>
    <message>
        <source>a reader that stopped half way</source>
        <translation>yarıda duran bir okuyucu</translation>
    </message>
    <message>
        <source>a reader that used up its processor time</source>
        <translation>işlemci süresini tüketen bir okuyucu</translation>
    </message>
    <message>
        <source>a reference to %1</source>
        <translation>%1 dosyasına bir gönderme</translation>
    </message>
    <message>
        <source>a region of the organ: %1</source>
        <translation>organın bir bölgesi: %1</translation>
    </message>
    <message>
        <source>a run of at most 2 h 19 min at 1 kHz, shared between the instruments</source>
        <translation>1 kHz'de en çok 2 sa 19 dk süren, aletler arasında bölüşülen bir çalışma</translation>
    </message>
    <message>
        <source>a scene file</source>
        <translation>bir sahne dosyası</translation>
    </message>
    <message>
        <source>a scene file in another folder than its mesh</source>
        <translation>ağından başka klasörde bir sahne dosyası</translation>
    </message>
    <message>
        <source>a scene from build_scene</source>
        <translation>build_scene'den bir sahne</translation>
    </message>
    <message>
        <source>a scene that can be built</source>
        <translation>kurulabilen bir sahne</translation>
    </message>
    <message>
        <source>a scene whose derived fields are not filled in</source>
        <translation>türetilen alanları doldurulmamış bir sahne</translation>
    </message>
    <message>
        <source>a second bond along the same side</source>
        <translation>aynı kenar boyunca ikinci bir bağ</translation>
    </message>
    <message>
        <source>a size of %1 to %2</source>
        <translation>%1 ile %2 arası bir büyüklük</translation>
    </message>
    <message>
        <source>a smaller one</source>
        <translation>daha küçüğü</translation>
    </message>
    <message>
        <source>a smallest angle of %1 degrees</source>
        <translation>%1 derecelik en küçük açı</translation>
    </message>
    <message>
        <source>a solid, as build_solid makes it</source>
        <translation>build_solid'in yaptığı gibi bir dolu cisim</translation>
    </message>
    <message>
        <source>a sum of %1</source>
        <translation>%1 toplamı</translation>
    </message>
    <message>
        <source>a surface</source>
        <translation>bir yüzey</translation>
    </message>
    <message>
        <source>a surface made of triangles or polygons</source>
        <translation>üçgen ya da çokgenlerden oluşan bir yüzey</translation>
    </message>
    <message>
        <source>a surface that does not cross itself</source>
        <translation>kendisiyle kesişmeyen bir yüzey</translation>
    </message>
    <message>
        <source>a tangent at rest that K_theta %1 J makes indefinite at any K_btheta</source>
        <translation>K_theta %1 J ile her K_btheta'da belirsiz olan bir durgun teğet</translation>
    </message>
    <message>
        <source>a tissue that gives %1</source>
        <translation>%1 veren bir doku</translation>
    </message>
    <message>
        <source>a tissue with particles that have no home springs</source>
        <translation>yuva yayı olmayan parçacıkları olan bir doku</translation>
    </message>
    <message>
        <source>a tissue that relaxes</source>
        <translation>gevşeyen bir doku</translation>
    </message>
    <message>
        <source>0: what relaxes is moved whole, for it is never quite at rest</source>
        <translation>0: gevşeyen doku bütünüyle hareket ettirilir, çünkü hiçbir zaman tam durmaz</translation>
    </message>
    <message>
        <source>maxwell</source>
        <translation>Maxwell kolları</translation>
    </message>
    <message>
        <source>three different particles, 0 to %1</source>
        <translation>0 ile %1 arasında üç farklı parçacık</translation>
    </message>
    <message>
        <source>five different particles, 0 to %1</source>
        <translation>0 ile %1 arasında beş farklı parçacık</translation>
    </message>
    <message>
        <source>a tissue with prisms</source>
        <translation>prizmaları olan bir doku</translation>
    </message>
    <message>
        <source>a tissue with volumes</source>
        <translation>hacimleri olan bir doku</translation>
    </message>
    <message>
        <source>a triangle with an area</source>
        <translation>alanı olan bir üçgen</translation>
    </message>
    <message>
        <source>a value</source>
        <translation>bir değer</translation>
    </message>
    <message>
        <source>a volume of %1 m³</source>
        <translation>%1 m³ hacim</translation>
    </message>
    <message>
        <source>a volume of %1 m³ at rest</source>
        <translation>durgunken %1 m³ hacim</translation>
    </message>
    <message>
        <source>a whole number</source>
        <translation>bir tam sayı</translation>
    </message>
    <message>
        <source>a whole number from %1 to %2</source>
        <translation>%1 ile %2 arası bir tam sayı</translation>
    </message>
    <message>
        <source>a whole number of %1 to %2</source>
        <translation>%1 ile %2 arası bir tam sayı</translation>
    </message>
    <message>
        <source>a whole number, 0 or more</source>
        <translation>0 ya da daha büyük bir tam sayı</translation>
    </message>
    <message>
        <source>a whole one</source>
        <translation>sağlam bir arşiv</translation>
    </message>
    <message>
        <source>a zip archive</source>
        <translation>bir zip arşivi</translation>
    </message>
    <message>
        <source>above %1 N</source>
        <translation>%1 N üstü</translation>
    </message>
    <message>
        <source>an arm that can push anywhere in its workspace</source>
        <translation>çalışma alanının her yerinde itebilen bir kol</translation>
    </message>
    <message>
        <source>an array of no known table</source>
        <translation>bilinen hiçbir tabloya ait olmayan bir dizi</translation>
    </message>
    <message>
        <source>an edge or a vertex shared by too many</source>
        <translation>çok fazla üçgenin paylaştığı bir kenar ya da köşe</translation>
    </message>
    <message>
        <source>an element %1 with %2</source>
        <translation>%2 ile bir %1 öğesi</translation>
    </message>
    <message>
        <source>an empty file</source>
        <translation>boş bir dosya</translation>
    </message>
    <message>
        <source>an encrypted entry</source>
        <translation>şifreli bir girdi</translation>
    </message>
    <message>
        <source>an entry that the manifest does not name</source>
        <translation>manifest'in adını vermediği bir girdi</translation>
    </message>
    <message>
        <source>an imported mesh</source>
        <translation>içe aktarılmış bir ağ</translation>
    </message>
    <message>
        <source>an index below %1</source>
        <translation>%1 değerinden küçük bir sıra numarası</translation>
    </message>
    <message>
        <source>an inner face, %1 mm below, of %2 % of its area</source>
        <translation>%1 mm aşağıda, alanı onun %%2 kadarı olan bir iç yüz</translation>
    </message>
    <message>
        <source>an object</source>
        <translation>bir nesne</translation>
    </message>
    <message>
        <source>an open one, with %1%2</source>
        <translation>açık bir yüzey, %1%2 ile</translation>
    </message>
    <message>
        <source>an organ that a file can hold</source>
        <translation>bir dosyaya sığan bir organ</translation>
    </message>
    <message>
        <source>an organ's size</source>
        <translation>bir organın boyu</translation>
    </message>
    <message>
        <source>an organ's surface</source>
        <translation>bir organın yüzeyi</translation>
    </message>
    <message>
        <source>an unknown array</source>
        <translation>bilinmeyen bir dizi</translation>
    </message>
    <message>
        <source>an unknown field</source>
        <translation>bilinmeyen bir alan</translation>
    </message>
    <message>
        <source>an unknown member %1</source>
        <translation>bilinmeyen %1 üyesi</translation>
    </message>
    <message>
        <source>angles</source>
        <translation>açılar</translation>
    </message>
    <message>
        <source>another law</source>
        <translation>başka bir yasa</translation>
    </message>
    <message>
        <source>answered, but not with its calibration or a report</source>
        <translation>yanıt verdi ama kalibrasyonunu ya da bir rapor göndermedi</translation>
    </message>
    <message>
        <source>0 for the hard law, or E / (1 - nu^2) of the tissue</source>
        <translation>sert yasa için 0, ya da dokunun E / (1 - nu^2) değeri</translation>
    </message>
    <message>
        <source>a stiffness that cannot be solved with</source>
        <translation>çözülemeyen bir katılık</translation>
    </message>
    <message>
        <source>one that is positive</source>
        <translation>pozitif bir katılık</translation>
    </message>
    <message>
        <source>any number</source>
        <translation>herhangi bir sayı</translation>
    </message>
    <message>
        <source>arrays of more than %1 bytes</source>
        <translation>%1 bayttan büyük diziler</translation>
    </message>
    <message>
        <source>as asked</source>
        <translation>istendiği gibi</translation>
    </message>
    <message>
        <source>as many of both</source>
        <translation>ikisinden eşit sayıda</translation>
    </message>
    <message>
        <source>ascending ones from 0 to %1</source>
        <translation>0 ile %1 arası artan sayılar</translation>
    </message>
    <message>
        <source>ascending particles</source>
        <translation>artan sırada parçacıklar</translation>
    </message>
    <message>
        <source>ascending particles, 0 to %1</source>
        <translation>artan sırada parçacıklar, 0 ile %1 arası</translation>
    </message>
    <message>
        <source>at least %1 %: a thinner wall, or a surface with wider bends</source>
        <translation>en az %%1: daha ince bir duvar ya da daha geniş kıvrımlı bir yüzey</translation>
    </message>
    <message>
        <source>at least %1 degrees</source>
        <translation>en az %1 derece</translation>
    </message>
    <message>
        <source>at least %1 mm for at most %2</source>
        <translation>en çok %2 için en az %1 mm</translation>
    </message>
    <message>
        <source>at least one</source>
        <translation>en az bir tane</translation>
    </message>
    <message>
        <source>at least one to touch</source>
        <translation>dokunmak için en az bir tane</translation>
    </message>
    <message>
        <source>at least one to touch with</source>
        <translation>dokunmak için kullanılacak en az bir tane</translation>
    </message>
    <message>
        <source>an integrator that this program knows, such as symplectic_euler</source>
        <translation>bu programın bildiği bir zaman adımlayıcı, örneğin symplectic_euler</translation>
    </message>
    <message>
        <source>a list of 1 to %1</source>
        <translation>1 ile %1 arası öğelik bir liste</translation>
    </message>
    <message>
        <source>a multiple of %1, one for each instrument in every tick</source>
        <translation>%1 sayısının katı: her tikte her alet için bir tane</translation>
    </message>
    <message>
        <source>%1 samples</source>
        <translation>%1 örnek</translation>
    </message>
    <message>
        <source>%1 rows with those of the bodies before</source>
        <translation>önceki cisimlerinkilerle %1 satır</translation>
    </message>
    <message>
        <source>at least %1</source>
        <translation>en az %1</translation>
    </message>
    <message>
        <source>driver refused low latency</source>
        <translation>sürücü düşük gecikmeyi kabul etmedi</translation>
    </message>
    <message>
        <source>driver set to low latency</source>
        <translation>sürücü düşük gecikmeye ayarlandı</translation>
    </message>
    <message>
        <source>latency timer %1 ms: a udev rule with ATTR{latency_timer}="1" would make the loop %2 ms shorter</source>
        <translation>gecikme sayacı %1 ms: ATTR{latency_timer}="1" içeren bir udev kuralı döngüyü %2 ms kısaltır</translation>
    </message>
    <message>
        <source>latency timer 1 ms</source>
        <translation>gecikme sayacı 1 ms</translation>
    </message>
    <message>
        <source>nothing here keeps bytes back</source>
        <translation>burada baytları bekleten bir şey yok</translation>
    </message>
    <message>
        <source>scene: %1</source>
        <translation>sahne: %1</translation>
    </message>
    <message>
        <source>at most %1</source>
        <translation>en çok %1</translation>
    </message>
    <message>
        <source>at most %1 MB: fill with fewer tetrahedra, or limit the reach of pushes</source>
        <translation>en çok %1 MB: daha az dörtyüzlüyle doldurun ya da bastırılan yeri sınırlayın</translation>
    </message>
    <message>
        <source>at most %1 bytes</source>
        <translation>en çok %1 bayt</translation>
    </message>
    <message>
        <source>at most %1 entries</source>
        <translation>en çok %1 girdi</translation>
    </message>
    <message>
        <source>at most %1, what this editor knows</source>
        <translation>en çok %1, bu düzenleyicinin bildiği</translation>
    </message>
    <message>
        <source>at most %1: fill with smaller cells</source>
        <translation>en çok %1: daha küçük hücrelerle doldurun</translation>
    </message>
    <message>
        <source>at most 1 GB</source>
        <translation>en çok 1 GB</translation>
    </message>
    <message>
        <source>at most 1 MiB</source>
        <translation>en çok 1 MiB</translation>
    </message>
    <message>
        <source>at most one other</source>
        <translation>en çok bir başkası</translation>
    </message>
    <message>
        <source>at most two triangles at an edge</source>
        <translation>bir kenarda en çok iki üçgen</translation>
    </message>
    <message>
        <source>below %1 N</source>
        <translation>%1 N altı</translation>
    </message>
    <message>
        <source>between %1 and %2</source>
        <translation>%1 ile %2 arası</translation>
    </message>
    <message>
        <source>between -%1 and %2</source>
        <translation>-%1 ile %2 arası</translation>
    </message>
    <message>
        <source>bonds</source>
        <translation>bağlar</translation>
    </message>
    <message>
        <source>both</source>
        <translation>ikisi de</translation>
    </message>
    <message>
        <source>byte %1</source>
        <translation>%1. bayt</translation>
    </message>
    <message>
        <source>compression method %1</source>
        <translation>sıkıştırma yöntemi %1</translation>
    </message>
    <message>
        <source>content assimp refuses (%1)</source>
        <translation>assimp'in kabul etmediği içerik (%1)</translation>
    </message>
    <message>
        <source>content still being read after %1</source>
        <translation>%1 sonra hâlâ okunan içerik</translation>
    </message>
    <message>
        <source>content that crashes the reader (%1)</source>
        <translation>okuyucuyu çökerten içerik (%1)</translation>
    </message>
    <message>
        <source>coordinates too large to measure</source>
        <translation>ölçülemeyecek kadar büyük koordinatlar</translation>
    </message>
    <message>
        <source>damaged bytes</source>
        <translation>bozuk baytlar</translation>
    </message>
    <message>
        <source>decimate: vertex_count must be 4 to %1, the vertices of the mesh, got %2</source>
        <translation>sadeleştirme: köşe sayısı 4 ile ağın köşe sayısı %1 arası olmalı, verilen %2</translation>
    </message>
    <message>
        <source>decimate: vertex_count must be at least %1, as far as this mesh goes, got %2</source>
        <translation>sadeleştirme: köşe sayısı bu ağ için en az %1 olmalı, verilen %2</translation>
    </message>
    <message>
        <source>did not confirm what was to be stored</source>
        <translation>saklanması isteneni onaylamadı</translation>
    </message>
    <message>
        <source>does not answer: expected a Palpate device that is switched on</source>
        <translation>yanıt vermiyor; beklenen: açık bir Palpate aygıtı</translation>
    </message>
    <message>
        <source>edge %1-%2 already between triangles %3 and %4</source>
        <translation>zaten %3 ve %4 üçgenleri arasında olan %1-%2 kenarı</translation>
    </message>
    <message>
        <source>edge %1-%2 run in the same direction as in triangle %3</source>
        <translation>%3 üçgenindekiyle aynı yönde giden %1-%2 kenarı</translation>
    </message>
    <message>
        <source>endfacet and endsolid</source>
        <translation>endfacet ve endsolid</translation>
    </message>
    <message>
        <source>entries that share their bytes</source>
        <translation>aynı baytları paylaşan girdiler</translation>
    </message>
    <message>
        <source>every field of it</source>
        <translation>bütün alanları</translation>
    </message>
    <message>
        <source>every name once</source>
        <translation>her ad bir kez</translation>
    </message>
    <message>
        <source>every vertex in one</source>
        <translation>her köşe bir tanesinde</translation>
    </message>
    <message>
        <source>exactly %1</source>
        <translation>tam olarak %1</translation>
    </message>
    <message>
        <source>f and three corners or more</source>
        <translation>f ve üç ya da daha çok köşe</translation>
    </message>
    <message>
        <source>face %1</source>
        <translation>%1. yüz</translation>
    </message>
    <message>
        <source>fewer</source>
        <translation>daha az</translation>
    </message>
    <message>
        <source>finite coordinates</source>
        <translation>sonlu koordinatlar</translation>
    </message>
    <message>
        <source>finite numbers</source>
        <translation>sonlu sayılar</translation>
    </message>
    <message>
        <source>format %1</source>
        <translation>%1 biçimi</translation>
    </message>
    <message>
        <source>format, element, property of a known type, comment or end_header</source>
        <translation>format, element, bilinen türde property, comment ya da end_header</translation>
    </message>
    <message>
        <source>four different particles, 0 to %1</source>
        <translation>dört ayrı parçacık, 0 ile %1 arası</translation>
    </message>
    <message>
        <source>got %1, expected %2</source>
        <translation>verilen: %1; beklenen: %2</translation>
    </message>
    <message>
        <source>height %1 m over a side of %2 m</source>
        <translation>%2 m kenar üzerinde %1 m yükseklik</translation>
    </message>
    <message>
        <source>in no tetrahedron</source>
        <translation>hiçbir dörtyüzlüde değil</translation>
    </message>
    <message>
        <source>larger bond shares or K_theta, for no K_btheta makes it positive definite</source>
        <translation>daha büyük bağ payları ya da K_theta; hiçbir K_btheta onu artı tanımlı yapmaz</translation>
    </message>
    <message>
        <source>less than %1</source>
        <translation>%1 değerinden küçük</translation>
    </message>
    <message>
        <source>less than max</source>
        <translation>max değerinden küçük</translation>
    </message>
    <message>
        <source>line %1</source>
        <translation>%1. satır</translation>
    </message>
    <message>
        <source>mesh: surfaces touch in vertices without an edge between them; expected them apart, as repair_mesh makes them</source>
        <translation>ağ: yüzeyler aralarında kenar olmadan köşelerde değiyor; repair_mesh'in yaptığı gibi ayrı olmaları beklenir</translation>
    </message>
    <message>
        <source>more bytes than stated</source>
        <translation>belirtilenden çok bayt</translation>
    </message>
    <message>
        <source>more than %1 levels</source>
        <translation>%1 düzeyden çok</translation>
    </message>
    <message>
        <source>more than 8388608 %1</source>
        <translation>8388608 taneden çok %1</translation>
    </message>
    <message>
        <source>more than %1 ticks</source>
        <translation>%1 tikten çok</translation>
    </message>
    <message>
        <source>more than ten million triangles</source>
        <translation>on milyondan çok üçgen</translation>
    </message>
    <message>
        <source>more triangles upon each other than can be counted</source>
        <translation>sayılamayacak kadar çok üst üste üçgen</translation>
    </message>
    <message>
        <source>motors that cannot carry the arm's weight or links that do not reach</source>
        <translation>kolun ağırlığını taşıyamayan motorlar ya da yetişmeyen uzuvlar</translation>
    </message>
    <message>
        <source>neighbours that agree on which side is outside, and two to an edge at most</source>
        <translation>hangi yanın dışarısı olduğunda uyuşan komşular ve bir kenarda en çok iki tane</translation>
    </message>
    <message>
        <source>no %1</source>
        <translation>%1 yok</translation>
    </message>
    <message>
        <source>no K_btheta that both can take with K_theta %1 J</source>
        <translation>K_theta %1 J ile ikisinin de kaldırabileceği K_btheta yok</translation>
    </message>
    <message>
        <source>no constants</source>
        <translation>sabit yok</translation>
    </message>
    <message>
        <source>no document of an editor</source>
        <translation>bir düzenleyicinin belgesi değil</translation>
    </message>
    <message>
        <source>no elastic tetrahedra</source>
        <translation>esnek dörtyüzlü yok</translation>
    </message>
    <message>
        <source>no extension</source>
        <translation>uzantısı olmayan bir ad</translation>
    </message>
    <message>
        <source>no faces</source>
        <translation>yüz yok</translation>
    </message>
    <message>
        <source>no format</source>
        <translation>biçim yok</translation>
    </message>
    <message>
        <source>no manifest.json</source>
        <translation>manifest.json yok</translation>
    </message>
    <message>
        <source>no name or size</source>
        <translation>adı ya da boyu olmayan bir girdi</translation>
    </message>
    <message>
        <source>no object</source>
        <translation>nesne değil</translation>
    </message>
    <message>
        <source>no other law</source>
        <translation>başka yasa olmaması</translation>
    </message>
    <message>
        <source>no particle of the surface that moves</source>
        <translation>yüzeyde hareket eden parçacık yok</translation>
    </message>
    <message>
        <source>no particles</source>
        <translation>parçacık yok</translation>
    </message>
    <message>
        <source>no such array</source>
        <translation>böyle bir dizi yok</translation>
    </message>
    <message>
        <source>no such file</source>
        <translation>böyle bir dosya yok</translation>
    </message>
    <message>
        <source>no such part</source>
        <translation>böyle bir parça yok</translation>
    </message>
    <message>
        <source>no surface</source>
        <translation>yüzey yok</translation>
    </message>
    <message>
        <source>no tetrahedra</source>
        <translation>dörtyüzlü yok</translation>
    </message>
    <message>
        <source>no triangle that has an area</source>
        <translation>alanı olan üçgen yok</translation>
    </message>
    <message>
        <source>no triangle that uses it</source>
        <translation>onu kullanan üçgen yok</translation>
    </message>
    <message>
        <source>no triangle with three different corners</source>
        <translation>üç ayrı köşesi olan üçgen yok</translation>
    </message>
    <message>
        <source>no triangles</source>
        <translation>hiç üçgen yok</translation>
    </message>
    <message>
        <source>no vertex in %1</source>
        <translation>%1 içinde köşe yok</translation>
    </message>
    <message>
        <source>none</source>
        <translation>hiç</translation>
    </message>
    <message>
        <source>none for an open surface</source>
        <translation>açık bir yüzey için hiç</translation>
    </message>
    <message>
        <source>none such</source>
        <translation>böyle girdi olmaması</translation>
    </message>
    <message>
        <source>none, or one per vertex: %1</source>
        <translation>hiç ya da her köşeye bir tane: %1</translation>
    </message>
    <message>
        <source>none: a solid is filled</source>
        <translation>hiç: dolu cismin içi doludur</translation>
    </message>
    <message>
        <source>none: the surface is closed</source>
        <translation>hiç: yüzey kapalı</translation>
    </message>
    <message>
        <source>nothing</source>
        <translation>hiçbir şey</translation>
    </message>
    <message>
        <source>number %1 that is infinite or not a number</source>
        <translation>sonsuz olan ya da sayı olmayan %1. sayı</translation>
    </message>
    <message>
        <source>one</source>
        <translation>bir tane</translation>
    </message>
    <message>
        <source>one from build_scene</source>
        <translation>build_scene'den bir sahne</translation>
    </message>
    <message>
        <source>one of %1</source>
        <translation>şunlardan biri: %1</translation>
    </message>
    <message>
        <source>one that can be opened</source>
        <translation>açılabilen bir girdi</translation>
    </message>
    <message>
        <source>one that does not</source>
        <translation>böyle olmayan bir dosya</translation>
    </message>
    <message>
        <source>one that gives a finite number</source>
        <translation>sonlu bir sayı veren bir doku</translation>
    </message>
    <message>
        <source>one that it does: the file is saved, but a loss of power may bring back what stood there before</source>
        <translation>eşitlediği bir klasör: dosya kaydedildi, ama elektrik kesilirse önceki hâli geri gelebilir</translation>
    </message>
    <message>
        <source>one; it may be empty</source>
        <translation>bir tane; boş olabilir</translation>
    </message>
    <message>
        <source>other numbers</source>
        <translation>başka sayılar</translation>
    </message>
    <message>
        <source>other tables than the corners give</source>
        <translation>köşelerin verdiğinden başka tablolar</translation>
    </message>
    <message>
        <source>outside by %1 heights of the nearest tetrahedron</source>
        <translation>en yakın dörtyüzlünün %1 yüksekliği kadar dışarıda</translation>
    </message>
    <message>
        <source>automatic, packed or reference for a tissue that is no linear solid</source>
        <translation>doğrusal dolu cisim olmayan bir doku için automatic, packed ya da reference</translation>
    </message>
    <message>
        <source>particle %1</source>
        <translation>%1 parçacığı</translation>
    </message>
    <message>
        <source>particles held that do not lie on one line, or home springs</source>
        <translation>tek doğru üzerinde olmayan tutulmuş parçacıklar ya da yuva yayları</translation>
    </message>
    <message>
        <source>ply</source>
        <translation>ply</translation>
    </message>
    <message>
        <source>prisms</source>
        <translation>prizmalar</translation>
    </message>
    <message>
        <source>pseudo terminal: %1</source>
        <translation>sözde uçbirim: %1</translation>
    </message>
    <message>
        <source>published values</source>
        <translation>yayımlanmış değerler</translation>
    </message>
    <message>
        <source>read_mesh: memory_limit must be positive, got 0</source>
        <translation>read_mesh: memory_limit artı olmalı, verilen 0</translation>
    </message>
    <message>
        <source>read_mesh: time_limit must be above 0 and at most 3600 s, got %1</source>
        <translation>read_mesh: time_limit 0'dan büyük ve en çok 3600 s olmalı, verilen %1</translation>
    </message>
    <message>
        <source>record header: got text that is not a JSON object: %1</source>
        <translation>kayıt başlığı: verilen metin bir JSON nesnesi değil: %1</translation>
    </message>
    <message>
        <source>references to files beside the mesh or below its folder</source>
        <translation>ağın yanındaki ya da klasörünün altındaki dosyalara göndermeler</translation>
    </message>
    <message>
        <source>response</source>
        <translation>response</translation>
    </message>
    <message>
        <source>room to write</source>
        <translation>yazacak yer</translation>
    </message>
    <message>
        <source>row %1</source>
        <translation>%1. satır</translation>
    </message>
    <message>
        <source>sends what is no frame of ours: another device, or another baud rate</source>
        <translation>bizim olmayan iletiler gönderiyor: başka bir aygıt ya da başka bir hız</translation>
    </message>
    <message>
        <source>shares of a bond %1, %2</source>
        <translation>bir bağın payları %1, %2</translation>
    </message>
    <message>
        <source>ships with Palpate</source>
        <translation>Palpate ile gelir</translation>
    </message>
    <message>
        <source>six different particles, 0 to %1</source>
        <translation>altı ayrı parçacık, 0 ile %1 arası</translation>
    </message>
    <message>
        <source>small letters, digits, _ - and ., in parts joined by /</source>
        <translation>küçük harfler, rakamlar, _ - ve .; / ile birleşen parçalarda</translation>
    </message>
    <message>
        <source>solid, facet, outer loop, vertex, endloop, endfacet or endsolid</source>
        <translation>solid, facet, outer loop, vertex, endloop, endfacet ya da endsolid</translation>
    </message>
    <message>
        <source>something other than a file</source>
        <translation>dosya olmayan bir şey</translation>
    </message>
    <message>
        <source>something other than a zip archive</source>
        <translation>zip arşivi olmayan bir şey</translation>
    </message>
    <message>
        <source>something that is not a regular file</source>
        <translation>sıradan bir dosya olmayan bir şey</translation>
    </message>
    <message>
        <source>speaks version %1 of the protocol, expected %2</source>
        <translation>protokolün %1 sürümünü konuşuyor; beklenen: %2</translation>
    </message>
    <message>
        <source>springs</source>
        <translation>yaylar</translation>
    </message>
    <message>
        <source>stated by the file or its format</source>
        <translation>dosya ya da biçimi belirtiyor</translation>
    </message>
    <message>
        <source>stored or deflated</source>
        <translation>saklanmış ya da deflate ile sıkıştırılmış</translation>
    </message>
    <message>
        <source>text</source>
        <translation>metin</translation>
    </message>
    <message>
        <source>text that is not JSON</source>
        <translation>JSON olmayan bir metin</translation>
    </message>
    <message>
        <source>text that is not JSON (%1)</source>
        <translation>JSON olmayan bir metin (%1)</translation>
    </message>
    <message>
        <source>text that is not JSON from byte %1</source>
        <translation>%1. bayttan sonrası JSON olmayan bir metin</translation>
    </message>
    <message>
        <source>text that is not UTF-8</source>
        <translation>UTF-8 olmayan bir metin</translation>
    </message>
    <message>
        <source>text, or at least %1 bytes</source>
        <translation>metin ya da en az %1 bayt</translation>
    </message>
    <message>
        <source>that bond in the table</source>
        <translation>tabloda o bağ</translation>
    </message>
    <message>
        <source>the bytes its checksum tells</source>
        <translation>sağlama toplamının söylediği baytlar</translation>
    </message>
    <message>
        <source>the cable is out</source>
        <translation>kablosu çıkmış</translation>
    </message>
    <message>
        <source>the code %1</source>
        <translation>%1 kodu</translation>
    </message>
    <message>
        <source>the code %1, %2</source>
        <translation>%1 kodu: %2</translation>
    </message>
    <message>
        <source>the end of the file</source>
        <translation>dosyanın sonu</translation>
    </message>
    <message>
        <source>the end within a facet</source>
        <translation>bir yüzün ortasında son</translation>
    </message>
    <message>
        <source>the extension %1</source>
        <translation>%1 uzantısı</translation>
    </message>
    <message>
        <source>the format states none; medical programs have z up</source>
        <translation>biçim bir şey belirtmiyor; tıbbi programlarda z yukarıdır</translation>
    </message>
    <message>
        <source>the mesh the scene was made with</source>
        <translation>sahnenin yapıldığı ağ</translation>
    </message>
    <message>
        <source>the name %1, %2</source>
        <translation>%1 adı: %2</translation>
    </message>
    <message>
        <source>the name of a file</source>
        <translation>bir dosyanın adı</translation>
    </message>
    <message>
        <source>the one the manifest names</source>
        <translation>manifest'in adını verdiği</translation>
    </message>
    <message>
        <source>the program palpate-read-mesh of this installation</source>
        <translation>bu kurulumun palpate-read-mesh programı</translation>
    </message>
    <message>
        <source>the result of build_scene</source>
        <translation>build_scene'in sonucu</translation>
    </message>
    <message>
        <source>the same folder, so that both move together</source>
        <translation>aynı klasör, ikisi birlikte taşınsın diye</translation>
    </message>
    <message>
        <source>the suffix %1</source>
        <translation>%1 uzantısı</translation>
    </message>
    <message>
        <source>the thickness of the membrane [m]</source>
        <translation>zarın kalınlığı [m]</translation>
    </message>
    <message>
        <source>the thickness of the wall [m]</source>
        <translation>duvarın kalınlığı [m]</translation>
    </message>
    <message>
        <source>the thickness of the wall [m], since what is open encloses no volume</source>
        <translation>duvarın kalınlığı [m]; açık olan bir hacim çevrelemez</translation>
    </message>
    <message>
        <source>those of an organ</source>
        <translation>bir organınkiler</translation>
    </message>
    <message>
        <source>those of build_elastic</source>
        <translation>build_elastic'inkiler</translation>
    </message>
    <message>
        <source>those of build_volumes</source>
        <translation>build_volumes'unkiler</translation>
    </message>
    <message>
        <source>three different ones</source>
        <translation>üç ayrı köşe</translation>
    </message>
    <message>
        <source>three different ones, 0 to %1</source>
        <translation>üç ayrı tane, 0 ile %1 arası</translation>
    </message>
    <message>
        <source>three finite numbers</source>
        <translation>üç sonlu sayı</translation>
    </message>
    <message>
        <source>three numbers of 0 to 1</source>
        <translation>0 ile 1 arası üç sayı</translation>
    </message>
    <message>
        <source>three or more</source>
        <translation>üç ya da daha çok</translation>
    </message>
    <message>
        <source>triangle %1</source>
        <translation>%1 üçgeni</translation>
    </message>
    <message>
        <source>true or false</source>
        <translation>doğru (true) ya da yanlış (false)</translation>
    </message>
    <message>
        <source>two ascending particles, 0 to %1</source>
        <translation>artan sırada iki parçacık, 0 ile %1 arası</translation>
    </message>
    <message>
        <source>two entries of one name</source>
        <translation>aynı adda iki girdi</translation>
    </message>
    <message>
        <source>two entries of this name</source>
        <translation>bu adda iki girdi</translation>
    </message>
    <message>
        <source>two members named %1</source>
        <translation>%1 adlı iki üye</translation>
    </message>
    <message>
        <source>unit must be m, cm, mm, um, in or ft, got '%1'</source>
        <translation>birim m, cm, mm, um, in ya da ft olmalı, verilen '%1'</translation>
    </message>
    <message>
        <source>unknown part %1</source>
        <translation>bilinmeyen bölüm %1</translation>
    </message>
    <message>
        <source>up must be x, y, z, -x, -y or -z, got '%1'</source>
        <translation>yukarı yön x, y, z, -x, -y ya da -z olmalı, verilen '%1'</translation>
    </message>
    <message>
        <source>v and three finite numbers</source>
        <translation>v ve üç sonlu sayı</translation>
    </message>
    <message>
        <source>v, f or another word of polygons in an OBJ</source>
        <translation>v, f ya da OBJ'de çokgenlere ait başka bir sözcük</translation>
    </message>
    <message>
        <source>values within more than %1 others</source>
        <translation>%1 kattan çok iç içe değerler</translation>
    </message>
    <message>
        <source>vertex %1</source>
        <translation>köşe %1</translation>
    </message>
    <message>
        <source>vertex and three finite numbers</source>
        <translation>vertex ve üç sonlu sayı</translation>
    </message>
    <message>
        <source>vertex and three numbers</source>
        <translation>vertex ve üç sayı</translation>
    </message>
    <message>
        <source>vertex numbers %1 to %2</source>
        <translation>%1 ile %2 arası köşe numaraları</translation>
    </message>
    <message>
        <source>vertices %1, %2, %3</source>
        <translation>%1, %2, %3 köşeleri</translation>
    </message>
    <message>
        <source>vertices 0 to %1</source>
        <translation>0 ile %1 arası köşeler</translation>
    </message>
    <message>
        <source>volumes</source>
        <translation>hacimler</translation>
    </message>
    <message>
        <source>what `palpate publish` writes</source>
        <translation>`palpate publish` komutunun yazdığı</translation>
    </message>
    <message>
        <source>which does not begin with two or three small letters</source>
        <translation>iki ya da üç küçük harfle başlamıyor</translation>
    </message>
    <message>
        <source>which is empty or too long</source>
        <translation>boş ya da çok uzun</translation>
    </message>
    <message>
        <source>which is the manifest's own</source>
        <translation>manifest'in kendi adı</translation>
    </message>
    <message>
        <source>which is too long</source>
        <translation>çok uzun</translation>
    </message>
    <message>
        <source>which leads out of the file</source>
        <translation>dosyanın dışına çıkıyor</translation>
    </message>
    <message>
        <source>with a part that is not 1 to 8 letters or digits</source>
        <translation>1 ile 8 harf ya da rakam olmayan bir bölümü var</translation>
    </message>
    <message>
        <source>with other characters</source>
        <translation>başka karakterler içeriyor</translation>
    </message>
    <message>
        <source>at most %1 in a solid of this kind, which a published file has room for: ask for fewer</source>
        <translation>bu türden bir dolu cisimde en çok %1; yayımlanan dosyada bu kadarına yer vardır: daha azını isteyin</translation>
    </message>
    <message>
        <source>corotated</source>
        <translation>eşdöner dört yüzlüler</translation>
    </message>
    <message>
        <source>those of build_hyperelastic</source>
        <translation>build_hyperelastic'inkiler</translation>
    </message>
    <message>
        <source>a corotated solid</source>
        <translation>eşdöner bir dolu cisim</translation>
    </message>
    <message>
        <source>a neo-Hookean solid</source>
        <translation>neo-Hooke bir dolu cisim</translation>
    </message>
    <message>
        <source>automatic or reference for a corotated or neo-Hookean solid, which vector code does not step</source>
        <translation>eşdöner ya da neo-Hooke bir dolu cisim için automatic ya da reference; vektör kodu onu adımlamaz</translation>
    </message>
    <message>
        <source>packed</source>
        <translation>packed</translation>
    </message>
    <message>
        <source>OFF, COFF, NOFF, STOFF or 4OFF</source>
        <translation>OFF, COFF, NOFF, STOFF ya da 4OFF</translation>
    </message>
    <message>
        <source>a %1 file, which the package %2 reads, and it is not there</source>
        <translation>%2 paketinin okuduğu bir %1 dosyası; o paket burada yok</translation>
    </message>
    <message>
        <source>a vertex of %1 numbers</source>
        <translation>%1 sayılı bir köşe</translation>
    </message>
    <message>
        <source>a vertex of four numbers</source>
        <translation>dört sayılı bir köşe</translation>
    </message>
    <message>
        <source>a vertex of three numbers</source>
        <translation>üç sayılı bir köşe</translation>
    </message>
    <message>
        <source>how many corners a face has</source>
        <translation>bir yüzün kaç köşesi olduğu</translation>
    </message>
    <message>
        <source>how many vertices and faces there are</source>
        <translation>kaç köşe ve kaç yüz olduğu</translation>
    </message>
    <message>
        <source>polygons, or a grid of cells</source>
        <translation>çokgenler ya da hücrelerden bir ızgara</translation>
    </message>
    <message>
        <source>that package: pip install palpate-editor[formats]</source>
        <translation>o paket: pip install palpate-editor[formats]</translation>
    </message>
    <message>
        <source>the number of a vertex</source>
        <translation>bir köşenin numarası</translation>
    </message>
    <message>
        <source>three numbers</source>
        <translation>üç sayı</translation>
    </message>
    <message>
        <source>%1 letters</source>
        <translation>%1 harf</translation>
    </message>
    <message>
        <source>%1 tissues</source>
        <translation>%1 doku</translation>
    </message>
    <message>
        <source>%1 voxels</source>
        <translation>%1 voksel</translation>
    </message>
    <message>
        <source>%1 without a worker</source>
        <translation>%1, işçisi yok</translation>
    </message>
    <message>
        <source>%1, in SI here</source>
        <translation>%1, burada SI birimiyle</translation>
    </message>
    <message>
        <source>%1..., of this organ and path</source>
        <translation>%1..., bu organ ve yolun</translation>
    </message>
    <message>
        <source>Dask's client: pip install 'palpate-editor[cluster]'</source>
        <translation>Dask istemcisi: pip install 'palpate-editor[cluster]'</translation>
    </message>
    <message>
        <source>LOW:HIGH, LOW: or :HIGH</source>
        <translation>ALT:ÜST, ALT: ya da :ÜST</translation>
    </message>
    <message>
        <source>a configuration and what it came to</source>
        <translation>bir yapılandırma ve sonucu</translation>
    </message>
    <message>
        <source>a finished run</source>
        <translation>bitmiş bir koşu</translation>
    </message>
    <message>
        <source>a library</source>
        <translation>bir kitaplık</translation>
    </message>
    <message>
        <source>a list</source>
        <translation>bir liste</translation>
    </message>
    <message>
        <source>a list of at most %1 texts</source>
        <translation>en çok %1 metinlik bir liste</translation>
    </message>
    <message>
        <source>a list of three numbers</source>
        <translation>üç sayılık bir liste</translation>
    </message>
    <message>
        <source>a name that ships</source>
        <translation>birlikte gelen bir ad</translation>
    </message>
    <message>
        <source>a number that is unknown</source>
        <translation>bilinmeyen bir sayı</translation>
    </message>
    <message>
        <source>a region twice</source>
        <translation>bir bölge iki kez</translation>
    </message>
    <message>
        <source>a row, a cost, or what converged</source>
        <translation>bir satır, bir maliyet ya da yakınsamış olan</translation>
    </message>
    <message>
        <source>a table of a tissue</source>
        <translation>bir dokunun tablosu</translation>
    </message>
    <message>
        <source>a volume</source>
        <translation>bir hacim</translation>
    </message>
    <message>
        <source>a volume that takes longer to read</source>
        <translation>okunması daha uzun süren bir hacim</translation>
    </message>
    <message>
        <source>an array of shape %1</source>
        <translation>biçimi %1 olan bir dizi</translation>
    </message>
    <message>
        <source>an organ of several voxels</source>
        <translation>birkaç vokselden oluşan bir organ</translation>
    </message>
    <message>
        <source>at most %1 s</source>
        <translation>en çok %1 s</translation>
    </message>
    <message>
        <source>data that broke its reader</source>
        <translation>okuyucusunu bozan veri</translation>
    </message>
    <message>
        <source>edges are still too long after %1 rounds</source>
        <translation>kenarlar %1 turdan sonra hâlâ çok uzun</translation>
    </message>
    <message>
        <source>force and model</source>
        <translation>kuvvet ve model</translation>
    </message>
    <message>
        <source>labels or a range</source>
        <translation>etiketler ya da bir aralık</translation>
    </message>
    <message>
        <source>neither low nor high</source>
        <translation>ne alt ne üst sınır</translation>
    </message>
    <message>
        <source>neither or both</source>
        <translation>hiçbiri ya da ikisi</translation>
    </message>
    <message>
        <source>no list</source>
        <translation>liste değil</translation>
    </message>
    <message>
        <source>no package distributed</source>
        <translation>distributed paketi yok</translation>
    </message>
    <message>
        <source>no table</source>
        <translation>tablo değil</translation>
    </message>
    <message>
        <source>numbers of a volume</source>
        <translation>bir hacmin sayıları</translation>
    </message>
    <message>
        <source>one at least</source>
        <translation>en az bir</translation>
    </message>
    <message>
        <source>one of your own</source>
        <translation>kendinizden biri</translation>
    </message>
    <message>
        <source>one that can be built as it is</source>
        <translation>olduğu gibi kurulabilen biri</translation>
    </message>
    <message>
        <source>one tissue for each</source>
        <translation>her birine bir doku</translation>
    </message>
    <message>
        <source>scans are in millimetres</source>
        <translation>taramalar milimetredir</translation>
    </message>
    <message>
        <source>text of at most %1</source>
        <translation>en çok %1 uzunlukta metin</translation>
    </message>
    <message>
        <source>text that is no TOML (%1)</source>
        <translation>TOML olmayan metin (%1)</translation>
    </message>
    <message>
        <source>the address of a Dask scheduler</source>
        <translation>bir Dask zamanlayıcısının adresi</translation>
    </message>
    <message>
        <source>the lower end first</source>
        <translation>önce alt uç</translation>
    </message>
    <message>
        <source>the scan says where the patient's head is</source>
        <translation>tarama hastanın başının nerede olduğunu söyler</translation>
    </message>
    <message>
        <source>the wall folds, however thin it is made</source>
        <translation>duvar ne kadar ince yapılsa da katlanıyor</translation>
    </message>
    <message>
        <source>voxels without a surface</source>
        <translation>yüzeyi olmayan vokseller</translation>
    </message>
    <message>
        <source>who published it, and where</source>
        <translation>kim, nerede yayımladı</translation>
    </message>
    <message>
        <source>%1, the one known here</source>
        <translation>%1, burada bilinen tek sürüm</translation>
    </message>
    <message>
        <source>%1 to 1</source>
        <translation>%1 ile 1 arası</translation>
    </message>
    <message>
        <source>a body with an inside</source>
        <translation>içi olan bir cisim</translation>
    </message>
    <message>
        <source>a step that can be done</source>
        <translation>yapılabilen bir adım</translation>
    </message>
    <message>
        <source>a whole number of 0 or more</source>
        <translation>0 ya da daha büyük bir tam sayı</translation>
    </message>
    <message>
        <source>above 0 to 1</source>
        <translation>0'dan büyük, en çok 1</translation>
    </message>
    <message>
        <source>an .organ in which what was done is written down: this one is as it was read, or was made before its steps were kept</source>
        <translation>yapılanların yazılı olduğu bir .organ: bu, okunduğu gibi duruyor ya da adımlar saklanmadan önce yapılmış</translation>
    </message>
    <message>
        <source>an object of %1</source>
        <translation>şunlardan oluşan bir nesne: %1</translation>
    </message>
    <message>
        <source>an organ that was not imported</source>
        <translation>içe aktarılmamış bir organ</translation>
    </message>
    <message>
        <source>an unknown value</source>
        <translation>bilinmeyen bir değer</translation>
    </message>
    <message>
        <source>another array</source>
        <translation>başka bir dizi</translation>
    </message>
    <message>
        <source>another file</source>
        <translation>başka bir dosya</translation>
    </message>
    <message>
        <source>arrays by name</source>
        <translation>adlarıyla diziler</translation>
    </message>
    <message>
        <source>every value of it</source>
        <translation>her değeri</translation>
    </message>
    <message>
        <source>no line</source>
        <translation>satır yok</translation>
    </message>
    <message>
        <source>no original beside it</source>
        <translation>yanında özgün dosya olmaması</translation>
    </message>
    <message>
        <source>one that no cell fits into</source>
        <translation>içine hiçbir hücre sığmayan bir yüzey</translation>
    </message>
    <message>
        <source>other %1 of %2</source>
        <translation>%2 dosyasından başka %1</translation>
    </message>
    <message>
        <source>something else</source>
        <translation>başka bir şey</translation>
    </message>
    <message>
        <source>the one whose SHA-256 is %1</source>
        <translation>SHA-256 değeri %1 olan dosya</translation>
    </message>
    <message>
        <source>those of lines</source>
        <translation>satırlarınkiler</translation>
    </message>
    <message>
        <source>values that this step can be done with</source>
        <translation>bu adımın yapılabileceği değerler</translation>
    </message>
    <message>
        <source>what the organ keeps of it</source>
        <translation>organın ondan sakladığı</translation>
    </message>
    <message>
        <source>one that is not finite</source>
        <translation>sonlu olmayan bir tane</translation>
    </message>
    <message>
        <source>%1 mm or more, a thousandth of the diagonal</source>
        <translation>%1 mm ya da daha fazla: köşegenin binde biri</translation>
    </message>
    <message>
        <source>%1 of them</source>
        <translation>%1 tane</translation>
    </message>
    <message>
        <source>one for each of %1 vertices</source>
        <translation>%1 köşenin her biri için bir tane</translation>
    </message>
    <message>
        <source>about %1 triangles</source>
        <translation>yaklaşık %1 üçgen</translation>
    </message>
    <message>
        <source>edges so long that at most %1 come</source>
        <translation>en çok %1 üçgen çıkaracak kadar uzun kenarlar</translation>
    </message>
    <message>
        <source>%1 tensors</source>
        <translation>%1 tensör</translation>
    </message>
    <message>
        <source>%1, one per vertex of the surface</source>
        <translation>%1, yüzeyin her köşesi için bir tane</translation>
    </message>
    <message>
        <source>%1, six per vertex</source>
        <translation>%1, her köşe için altı tane</translation>
    </message>
    <message>
        <source>finite numbers [m/N]</source>
        <translation>sonlu sayılar [m/N]</translation>
    </message>
    <message>
        <source>none, or a solid</source>
        <translation>hiç biri ya da dolu bir organ</translation>
    </message>
    <message>
        <source>none: the hard law has no use for it</source>
        <translation>hiç biri: sert yasa bunu kullanmaz</translation>
    </message>
    <message>
        <source>one without a contact_modulus</source>
        <translation>contact_modulus olmadan bir tane</translation>
    </message>
    <message>
        <source>that of a wall of prisms</source>
        <translation>prizmalardan bir duvarınki</translation>
    </message>
    <message>
        <source>%1 %2, with which it asks for no more than the %3 that a tick of %4 ms has time for</source>
        <translation>%1 %2; bununla, %4 ms’lik bir adımın yetiştirebildiği %3 alt adımdan fazlasını istemez</translation>
    </message>
    <message>
        <source>%1 numbers of a colour</source>
        <translation>bir rengin %1 sayısı</translation>
    </message>
    <message>
        <source>%1 vertices without finite coordinates were left out, with %2 triangles on them; the first is %3</source>
        <translation>koordinatları sonlu olmayan %1 köşe, üzerlerindeki %2 üçgenle birlikte dışarıda bırakıldı; ilki %3</translation>
    </message>
    <message>
        <source>%1, which asks for %2 substeps a tick</source>
        <translation>%1; adım başına %2 alt adım ister</translation>
    </message>
    <message>
        <source>%1..., of this organ</source>
        <translation>%1..., bu organın</translation>
    </message>
    <message>
        <source>%1: format: expected %2 of version %3</source>
        <translation>%1: format: %3 sürümlü %2 bekleniyordu</translation>
    </message>
    <message>
        <source>a row</source>
        <translation>bir satır</translation>
    </message>
    <message>
        <source>as many as the file has</source>
        <translation>dosyada olduğu kadar</translation>
    </message>
    <message>
        <source>counts of vertices and faces</source>
        <translation>köşe ve yüz sayıları</translation>
    </message>
    <message>
        <source>ends without endsolid</source>
        <translation>endsolid olmadan bitiyor</translation>
    </message>
    <message>
        <source>its tetrahedra were left out: a coordinate is not a finite number</source>
        <translation>dörtyüzlüleri dışarıda bırakıldı: bir koordinat sonlu bir sayı değil</translation>
    </message>
    <message>
        <source>solid before it</source>
        <translation>ondan önce solid</translation>
    </message>
    <message>
        <source>the rest of a facet, and endfacet</source>
        <translation>bir facet’in kalanı ve endfacet</translation>
    </message>
    <message>
        <source>vertex</source>
        <translation>vertex</translation>
    </message>
    <message>
        <source>one of %1 substeps</source>
        <translation>%1 alt adımlık bir doku</translation>
    </message>
    <message>
        <source>one of at most 10000 substeps per tick, as this with %1 of all its stiffness and damping</source>
        <translation>her tikte en çok 10000 alt adım isteyen bir doku; tüm sertliğinin ve sönümünün %1 katıyla bu da öyledir</translation>
    </message>
    <message>
        <source>at least the %1 substeps that the tissue needs</source>
        <translation>en az dokunun gereksindiği %1 alt adım</translation>
    </message>
    <message>
        <source>%1 crossed itself: %2 of its triangles were replaced</source>
        <translation>%1 kendini kesiyordu: üçgenlerinden %2 tanesi yenilendi</translation>
    </message>
    <message>
        <source>"$%1" somewhere</source>
        <translation>bir yerde "$%1"</translation>
    </message>
    <message>
        <source>$ and the name of a parameter</source>
        <translation>$ ve bir parametrenin adı</translation>
    </message>
    <message>
        <source>$%1, which a mesh of Gmsh has</source>
        <translation>Gmsh ağında bulunan $%1</translation>
    </message>
    <message>
        <source>%1 %2 on points that are not there were left out</source>
        <translation>olmayan noktalara dayanan %1 %2 dışarıda bırakıldı</translation>
    </message>
    <message>
        <source>%1 once more</source>
        <translation>bir kez daha %1</translation>
    </message>
    <message>
        <source>%1, which cannot be judged yet: %2</source>
        <translation>henüz değerlendirilemeyen %1: %2</translation>
    </message>
    <message>
        <source>'%1', or &lt;VTKFile&gt;</source>
        <translation>'%1' ya da &lt;VTKFile&gt;</translation>
    </message>
    <message>
        <source>(n) of &lt;i4</source>
        <translation>&lt;i4 türünden (n)</translation>
    </message>
    <message>
        <source>0 for none, or %1 to the rate of %2 Hz</source>
        <translation>yoksa 0, varsa %1 ile %2 Hz'lik hız arası</translation>
    </message>
    <message>
        <source>%1, one per body, scenery and rigid body, or none</source>
        <translation>%1, her cisim, sabit çevre ve rijit cisim için bir tane, ya da hiç</translation>
    </message>
    <message>
        <source>0 for all with a tool.friction of 0: such a tool slides on everything</source>
        <translation>tool.friction 0 iken hepsi için 0: böyle bir alet her şeyin üzerinde kayar</translation>
    </message>
    <message>
        <source>0, or positive numbers</source>
        <translation>0 ya da pozitif sayılar</translation>
    </message>
    <message>
        <source>0, or a positive number</source>
        <translation>0 ya da pozitif bir sayı</translation>
    </message>
    <message>
        <source>1; it was made by a newer program, which is needed to open it</source>
        <translation>1; daha yeni bir programla yapılmış, açmak için o gerekir</translation>
    </message>
    <message>
        <source>[least, most], one of which may be null</source>
        <translation>[en az, en çok]; biri null olabilir</translation>
    </message>
    <message>
        <source>a file of Gmsh, version 1, 2, 4.0 or 4.1</source>
        <translation>sürümü 1, 2, 4.0 ya da 4.1 olan bir Gmsh dosyası</translation>
    </message>
    <message>
        <source>a least value no greater than the most</source>
        <translation>en çoktan büyük olmayan bir en az değer</translation>
    </message>
    <message>
        <source>a list of 1 to 10 names</source>
        <translation>1 ile 10 arası addan oluşan bir liste</translation>
    </message>
    <message>
        <source>a list of 1 to 100</source>
        <translation>1 ile 100 arası öğeli bir liste</translation>
    </message>
    <message>
        <source>a list of 2 to 1000 points [x, y, z]</source>
        <translation>2 ile 1000 arası [x, y, z] noktasından oluşan bir liste</translation>
    </message>
    <message>
        <source>a list of ids of steps</source>
        <translation>adım kimliklerinden oluşan bir liste</translation>
    </message>
    <message>
        <source>a mesh</source>
        <translation>bir ağ</translation>
    </message>
    <message>
        <source>a number from -1e6 to 1e6</source>
        <translation>-1e6 ile 1e6 arası bir sayı</translation>
    </message>
    <message>
        <source>a one of four bytes</source>
        <translation>dört baytlık bir 1</translation>
    </message>
    <message>
        <source>a parameter that nothing uses</source>
        <translation>hiçbir şeyin kullanmadığı bir parametre</translation>
    </message>
    <message>
        <source>a path, which is what is traced</source>
        <translation>izlenen şey olan bir yol</translation>
    </message>
    <message>
        <source>a place</source>
        <translation>bir yer</translation>
    </message>
    <message>
        <source>a place that is no path</source>
        <translation>yol olmayan bir yer</translation>
    </message>
    <message>
        <source>a property of a known type, of an element</source>
        <translation>bir öğenin bilinen türden bir özelliği</translation>
    </message>
    <message>
        <source>a scenario with a task that can be judged</source>
        <translation>değerlendirilebilen bir görevi olan bir senaryo</translation>
    </message>
    <message>
        <source>a step for which the tool must hold</source>
        <translation>aletin tutması gereken bir adım</translation>
    </message>
    <message>
        <source>a task that can be judged</source>
        <translation>değerlendirilebilen bir görev</translation>
    </message>
    <message>
        <source>a text %1</source>
        <translation>bir metin: %1</translation>
    </message>
    <message>
        <source>a text that texts.en has</source>
        <translation>texts.en içinde bulunan bir metin</translation>
    </message>
    <message>
        <source>a tool of the kind grasper</source>
        <translation>grasper türünde bir alet</translation>
    </message>
    <message>
        <source>a step for which the tool must see</source>
        <translation>aletin görmesi gereken bir adım</translation>
    </message>
    <message>
        <source>a tool of the kind laparoscope</source>
        <translation>laparoskop türünde bir alet</translation>
    </message>
    <message>
        <source>region, path, ball, object or space</source>
        <translation>region, path, ball, object veya space</translation>
    </message>
    <message>
        <source>a type of Gmsh's manual</source>
        <translation>Gmsh kılavuzundaki bir tür</translation>
    </message>
    <message>
        <source>a type of whole numbers after list</source>
        <translation>list sözünden sonra bir tam sayı türü</translation>
    </message>
    <message>
        <source>an array of an assessment</source>
        <translation>bir değerlendirmenin dizisi</translation>
    </message>
    <message>
        <source>an array of no region</source>
        <translation>hiçbir bölgenin olmayan bir dizi</translation>
    </message>
    <message>
        <source>an assessment</source>
        <translation>bir değerlendirme</translation>
    </message>
    <message>
        <source>an assessment, which says palpate_scenario first</source>
        <translation>önce palpate_scenario diyen bir değerlendirme</translation>
    </message>
    <message>
        <source>an empty band</source>
        <translation>boş bir aralık</translation>
    </message>
    <message>
        <source>an id of its own</source>
        <translation>kendine ait bir kimlik</translation>
    </message>
    <message>
        <source>an object of at most %1</source>
        <translation>en çok %1 öğeli bir nesne</translation>
    </message>
    <message>
        <source>an object of at most 50 languages</source>
        <translation>en çok 50 dilli bir nesne</translation>
    </message>
    <message>
        <source>another shape or type</source>
        <translation>başka bir biçim ya da tür</translation>
    </message>
    <message>
        <source>at_most, at_least or both</source>
        <translation>at_most, at_least ya da ikisi</translation>
    </message>
    <message>
        <source>each once</source>
        <translation>her biri bir kez</translation>
    </message>
    <message>
        <source>element NAME COUNT</source>
        <translation>element AD SAYI</translation>
    </message>
    <message>
        <source>faces without a list</source>
        <translation>listesi olmayan yüzler</translation>
    </message>
    <message>
        <source>false: the hard law has no use for them</source>
        <translation>false: sert yasa bunları kullanmaz</translation>
    </message>
    <message>
        <source>format ascii, binary_little_endian or binary_big_endian</source>
        <translation>format ascii, binary_little_endian ya da binary_big_endian</translation>
    </message>
    <message>
        <source>format ascii, binary_little_endian or binary_big_endian before</source>
        <translation>önce format ascii, binary_little_endian ya da binary_big_endian</translation>
    </message>
    <message>
        <source>format, element, property, comment or end_header</source>
        <translation>format, element, property, comment ya da end_header</translation>
    </message>
    <message>
        <source>how many %1 there are</source>
        <translation>kaç %1 olduğu</translation>
    </message>
    <message>
        <source>ids of places</source>
        <translation>yerlerin kimlikleri</translation>
    </message>
    <message>
        <source>names of small letters, digits, _ and -</source>
        <translation>küçük harf, rakam, _ ve - içeren adlar</translation>
    </message>
    <message>
        <source>no band of force, depth or distance</source>
        <translation>kuvvet, derinlik ya da uzaklık aralığı yok</translation>
    </message>
    <message>
        <source>no bound</source>
        <translation>sınır yok</translation>
    </message>
    <message>
        <source>no palpate_scenario</source>
        <translation>palpate_scenario yok</translation>
    </message>
    <message>
        <source>no place</source>
        <translation>yer yok</translation>
    </message>
    <message>
        <source>no regions</source>
        <translation>bölge yok</translation>
    </message>
    <message>
        <source>none, as there is no assessment</source>
        <translation>değerlendirme olmadığından hiçbiri</translation>
    </message>
    <message>
        <source>numbers</source>
        <translation>sayılar</translation>
    </message>
    <message>
        <source>of its %1 scenes the usual one was read</source>
        <translation>%1 sahnesinden olağan olanı okundu</translation>
    </message>
    <message>
        <source>one beside choose</source>
        <translation>choose yanında bir tane</translation>
    </message>
    <message>
        <source>one for each of %1 triangles</source>
        <translation>%1 üçgenin her biri için bir tane</translation>
    </message>
    <message>
        <source>one of the scenario's levels</source>
        <translation>senaryonun düzeylerinden biri</translation>
    </message>
    <message>
        <source>one that goes into the rate of %1 Hz a whole number of times, as %2 or %3</source>
        <translation>%1 Hz'lik hızı tam bölen bir sayı, örneğin %2 ya da %3</translation>
    </message>
    <message>
        <source>one that texts.en has too</source>
        <translation>texts.en içinde de bulunan biri</translation>
    </message>
    <message>
        <source>one with a task that can be judged</source>
        <translation>değerlendirilebilen bir görevi olan</translation>
    </message>
    <message>
        <source>one without an assessment</source>
        <translation>değerlendirmesi olmayan</translation>
    </message>
    <message>
        <source>organ/region, of %1</source>
        <translation>organ/bölge; organ: %1</translation>
    </message>
    <message>
        <source>points [x, y, z]</source>
        <translation>[x, y, z] noktaları</translation>
    </message>
    <message>
        <source>region, path or ball</source>
        <translation>bölge, yol ya da top</translation>
    </message>
    <message>
        <source>small letters, digits, _ and -</source>
        <translation>küçük harf, rakam, _ ve -</translation>
    </message>
    <message>
        <source>the end of the line</source>
        <translation>satırın sonu</translation>
    </message>
    <message>
        <source>the greater first</source>
        <translation>büyük olan önce</translation>
    </message>
    <message>
        <source>the id of a step</source>
        <translation>bir adımın kimliği</translation>
    </message>
    <message>
        <source>the least and the most</source>
        <translation>en az ve en çok</translation>
    </message>
    <message>
        <source>the region's vertices</source>
        <translation>bölgenin köşeleri</translation>
    </message>
    <message>
        <source>the texts in English</source>
        <translation>İngilizce metinler</translation>
    </message>
    <message>
        <source>their corners</source>
        <translation>bunların köşeleri</translation>
    </message>
    <message>
        <source>those of a wall of prisms</source>
        <translation>prizma duvarınınkiler</translation>
    </message>
    <message>
        <source>three coordinates</source>
        <translation>üç koordinat</translation>
    </message>
    <message>
        <source>too many texts</source>
        <translation>çok fazla metin</translation>
    </message>
    <message>
        <source>true without a contact_modulus</source>
        <translation>contact_modulus olmadan true</translation>
    </message>
    <message>
        <source>two numbers, the least and the most</source>
        <translation>iki sayı: en az ve en çok</translation>
    </message>
    <message>
        <source>vertices as plain numbers: save it without that compression</source>
        <translation>düz sayı olarak köşeler: bu sıkıştırma olmadan kaydedin</translation>
    </message>
    <message>
        <source>vertices without x, y, z</source>
        <translation>x, y, z olmayan köşeler</translation>
    </message>
    <message>
        <source>whole numbers of %1</source>
        <translation>%1 türünden tam sayılar</translation>
    </message>
    <message>
        <source>%1, as the scene has</source>
        <translation>sahnede olduğu gibi %1</translation>
    </message>
    <message>
        <source>%1, that of the instrument</source>
        <translation>aletinki olan %1</translation>
    </message>
    <message>
        <source>--person or --guest: %1 has no task that is judged</source>
        <translation>--person ya da --guest: %1 içinde değerlendirilen bir görev yok</translation>
    </message>
    <message>
        <source>--person: has not agreed to be recorded; `palpate records join` asks</source>
        <translation>--person: kaydedilmeyi kabul etmedi; `palpate records join` bunu sorar</translation>
    </message>
    <message>
        <source>0 for an instrument of capsules: between two exchanges a ball is felt</source>
        <translation>kapsüllerden oluşan bir alet için 0: iki alışveriş arasında bir küre hissedilir</translation>
    </message>
    <message>
        <source>0 for an instrument of capsules: how wrong sleep makes a force is known of balls</source>
        <translation>kapsüllerden oluşan bir alet için 0: uykunun kuvveti ne kadar saptırdığı yalnızca küreler için bilinir</translation>
    </message>
    <message>
        <source>%1 for instrument %2</source>
        <translation>%2. alet için %1</translation>
    </message>
    <message>
        <source>%1, %2, script:FILE or serial:PATH</source>
        <translation>%1, %2, script:DOSYA ya da serial:YOL</translation>
    </message>
    <message>
        <source>--fulcrum: the instrument of this scenario has no trocar to turn about</source>
        <translation>--fulcrum: bu senaryonun aletinin, çevresinde döneceği bir trokarı yok</translation>
    </message>
    <message>
        <source>a tool of two capsules, which are its jaws</source>
        <translation>çeneleri olan iki kapsüllü bir alet</translation>
    </message>
    <message>
        <source>a unit vector</source>
        <translation>birim vektör</translation>
    </message>
    <message>
        <source>an inclusion that can be built</source>
        <translation>kurulabilen bir kitle</translation>
    </message>
    <message>
        <source>at least %1 mm: so far is the organ behind the trocar</source>
        <translation>en az %1 mm: organ trokarın o kadar ötesinde</translation>
    </message>
    <message>
        <source>at most %1, one an instrument</source>
        <translation>en çok %1, her alete bir tane</translation>
    </message>
    <message>
        <source>more than 0, up to pi/2</source>
        <translation>0’dan büyük, en çok pi/2</translation>
    </message>
    <message>
        <source>one or more</source>
        <translation>bir ya da daha çok</translation>
    </message>
    <message>
        <source>the id of a place</source>
        <translation>bir yerin kimliği</translation>
    </message>
    <message>
        <source>within 0.5 m of the tool's position</source>
        <translation>aletin konumundan en çok 0,5 m uzakta</translation>
    </message>
    <message>
        <source>0, the hard law, for an instrument of several capsules: the near field is of one</source>
        <translation>birkaç kapsülden oluşan bir alet için 0, yani sert yasa: yakın alan tek bir kapsülünkidir</translation>
    </message>
    <message>
        <source>2.0: glTF 1 is read by hardly any program; save it as glTF 2.0 or OBJ</source>
        <translation>2.0: glTF 1’i neredeyse hiçbir program okumaz; glTF 2.0 ya da OBJ olarak kaydedin</translation>
    </message>
    <message>
        <source>a code of `palpate records join`</source>
        <translation>`palpate records join` komutunun verdiği bir kod</translation>
    </message>
    <message>
        <source>a database of records, or a new name</source>
        <translation>bir kayıt veritabanı ya da yeni bir ad</translation>
    </message>
    <message>
        <source>a positive radius</source>
        <translation>pozitif bir yarıçap</translation>
    </message>
    <message>
        <source>a surface: palpate segment cuts one out of a volume</source>
        <translation>bir yüzey: palpate segment bir hacimden yüzey çıkarır</translation>
    </message>
    <message>
        <source>a surface: palpate segment cuts one out of the volume once it is saved as .nrrd, .mha or .vtk</source>
        <translation>bir yüzey: hacim .nrrd, .mha ya da .vtk olarak kaydedilince palpate segment ondan yüzey çıkarır</translation>
    </message>
    <message>
        <source>a task of another scenario</source>
        <translation>başka bir senaryonun görevi</translation>
    </message>
    <message>
        <source>%1, which has no effect here: a ball has no jaws</source>
        <translation>%1, burada etkisi yok: kürenin çenesi yoktur</translation>
    </message>
    <message>
        <source>%1, which has no effect here: what has no jaws closes on nothing</source>
        <translation>%1, burada etkisi yok: çenesi olmayan hiçbir şeyi kavramaz</translation>
    </message>
    <message>
        <source>jaws that open, or none of it</source>
        <translation>açılan çeneler ya da hiç yazılmaması</translation>
    </message>
    <message>
        <source>a length above 0, or none of it</source>
        <translation>0'dan büyük bir uzunluk ya da hiç yazılmaması</translation>
    </message>
    <message>
        <source>a tool that can touch this organ</source>
        <translation>bu organa dokunabilen bir alet</translation>
    </message>
    <message>
        <source>a volume of voxels</source>
        <translation>voksellerden oluşan bir hacim</translation>
    </message>
    <message>
        <source>an array of no constant of tissue</source>
        <translation>dokunun hiçbir sabitine ait olmayan bir dizi</translation>
    </message>
    <message>
        <source>JSON that says palpate_scenario, as `palpate scenario new` writes it</source>
        <translation>palpate_scenario diyen bir JSON, `palpate scenario new` komutunun yazdığı gibi</translation>
    </message>
    <message>
        <source>no assessment</source>
        <translation>değerlendirme yok</translation>
    </message>
    <message>
        <source>an object that says palpate_scenario</source>
        <translation>palpate_scenario diyen bir nesne</translation>
    </message>
    <message>
        <source>another kind of file</source>
        <translation>başka türden bir dosya</translation>
    </message>
    <message>
        <source>at most %1; a newer program made it</source>
        <translation>en çok %1; daha yeni bir programla yapılmış</translation>
    </message>
    <message>
        <source>constants within the ranges of a scene</source>
        <translation>bir sahnenin aralıkları içinde kalan sabitler</translation>
    </message>
    <message>
        <source>ends within 0.5 m of the tool's position</source>
        <translation>aletin konumundan en çok 0,5 m uzakta olan uçlar</translation>
    </message>
    <message>
        <source>false for an instrument of capsules: how curved facets are is felt by balls</source>
        <translation>kapsüllerden oluşan bir alet için false: yüzlerin ne kadar eğri olduğunu küreler hisseder</translation>
    </message>
    <message>
        <source>false for an instrument of capsules: what is tied is the disc under a ball</source>
        <translation>kapsüllerden oluşan bir alet için false: bağlanan, bir kürenin altındaki disktir</translation>
    </message>
    <message>
        <source>false: under the hard law holds are fastened to vertices</source>
        <translation>false: sert yasada tutuşlar köşelere bağlanır</translation>
    </message>
    <message>
        <source>more than 0</source>
        <translation>0'dan büyük</translation>
    </message>
    <message>
        <source>no arrays</source>
        <translation>dizi yok</translation>
    </message>
    <message>
        <source>none for a ball: it has no shaft that would go through</source>
        <translation>küre için hiç: trokardan geçecek bir sapı yoktur</translation>
    </message>
    <message>
        <source>one of this</source>
        <translation>bu senaryonun bir görevi</translation>
    </message>
    <message>
        <source>that of the scene's table</source>
        <translation>sahnedeki tablonunki</translation>
    </message>
    <message>
        <source>the constants of the inclusion, which `palpate scenario publish` puts there</source>
        <translation>`palpate scenario publish` komutunun oraya koyduğu, kitlenin sabitleri</translation>
    </message>
    <message>
        <source>the path of a file on this machine</source>
        <translation>bu makinedeki bir dosyanın yolu</translation>
    </message>
    <message>
        <source>the place whose inclusion an attempt has</source>
        <translation>denemede kitlesi bulunan yer</translation>
    </message>
    <message>
        <source>version %1</source>
        <translation>%1 sürümü</translation>
    </message>
    <message>
        <source>who reviewed it, and as what</source>
        <translation>kimin, hangi sıfatla incelediği</translation>
    </message>
    <message>
        <source>#VRML V1.0 ascii, #VRML V2.0 utf8 or #Inventor V2.1</source>
        <translation>#VRML V1.0 ascii, #VRML V2.0 utf8 ya da #Inventor V2.1</translation>
    </message>
    <message>
        <source>%1 %2, as its first line says</source>
        <translation>ilk satırının dediği gibi %1 %2</translation>
    </message>
    <message>
        <source>%1 at least</source>
        <translation>en az %1</translation>
    </message>
    <message>
        <source>%1 colours</source>
        <translation>%1 renk</translation>
    </message>
    <message>
        <source>%1 corners and two cells</source>
        <translation>%1 köşe ve iki hücre</translation>
    </message>
    <message>
        <source>%1 faces</source>
        <translation>%1 yüz</translation>
    </message>
    <message>
        <source>%1 of %2</source>
        <translation>%1 / %2</translation>
    </message>
    <message>
        <source>%1 points and %2 cells, as its header says</source>
        <translation>başlığının dediği gibi %1 nokta ve %2 hücre</translation>
    </message>
    <message>
        <source>%1 points and %2 triangles</source>
        <translation>%1 nokta ve %2 üçgen</translation>
    </message>
    <message>
        <source>%1 points say a coordinate system of their own, which was not looked at</source>
        <translation>%1 nokta kendi koordinat sistemini söylüyor; ona bakılmadı</translation>
    </message>
    <message>
        <source>%1 whole numbers</source>
        <translation>%1 tam sayı</translation>
    </message>
    <message>
        <source>%1, as Fluent writes it without 'Binary'</source>
        <translation>Fluent'in 'Binary' olmadan yazdığı gibi %1</translation>
    </message>
    <message>
        <source>%1, as it says</source>
        <translation>dediği gibi %1</translation>
    </message>
    <message>
        <source>%1, one for each vertex</source>
        <translation>%1, her köşe için bir tane</translation>
    </message>
    <message>
        <source>%1.ele or %2.face beside it</source>
        <translation>yanında %1.ele ya da %2.face</translation>
    </message>
    <message>
        <source>*NODE and *ELEMENT of Abaqus</source>
        <translation>Abaqus'un *NODE ve *ELEMENT bölümleri</translation>
    </message>
    <message>
        <source>*NODE and *ELEMENT of LS-DYNA</source>
        <translation>LS-DYNA'nın *NODE ve *ELEMENT bölümleri</translation>
    </message>
    <message>
        <source>*VERTICES and *ELEMENTS of VegaFEM</source>
        <translation>VegaFEM'in *VERTICES ve *ELEMENTS bölümleri</translation>
    </message>
    <message>
        <source>0: the instrument has no trocar to turn about</source>
        <translation>0: aletin çevresinde döneceği bir trokar yok</translation>
    </message>
    <message>
        <source>3 numbers</source>
        <translation>3 sayı</translation>
    </message>
    <message>
        <source>4, 6 or 8 of a solid</source>
        <translation>bir katının 4, 6 ya da 8 köşesi</translation>
    </message>
    <message>
        <source>4d 5a, which an mz3 begins with</source>
        <translation>bir mz3'ün başladığı 4d 5a</translation>
    </message>
    <message>
        <source>6 of an element</source>
        <translation>bir elemanın 6 sayısı</translation>
    </message>
    <message>
        <source>ASCII, Base64Binary or GZipBase64Binary</source>
        <translation>ASCII, Base64Binary ya da GZipBase64Binary</translation>
    </message>
    <message>
        <source>GRID and elements of Nastran</source>
        <translation>Nastran'ın GRID satırları ve elemanları</translation>
    </message>
    <message>
        <source>IndexedFaceSet, a surface made of triangles or polygons</source>
        <translation>IndexedFaceSet: üçgen ya da çokgenlerden bir yüzey</translation>
    </message>
    <message>
        <source>TET or CUBIC</source>
        <translation>TET ya da CUBIC</translation>
    </message>
    <message>
        <source>[%1, %2, %3], that of the instrument</source>
        <translation>[%1, %2, %3], aletinki</translation>
    </message>
    <message>
        <source>a FreeSurfer surface</source>
        <translation>bir FreeSurfer yüzeyi</translation>
    </message>
    <message>
        <source>a ball</source>
        <translation>bir küre</translation>
    </message>
    <message>
        <source>a ball, a probe or a grasper: the instrument is a ball</source>
        <translation>bir küre, bir sonda ya da bir tutucu: alet bir küre</translation>
    </message>
    <message>
        <source>a file of GIFTI</source>
        <translation>bir GIFTI dosyası</translation>
    </message>
    <message>
        <source>a file of Medit: MeshVersionFormatted, Dimension 3, Vertices</source>
        <translation>bir Medit dosyası: MeshVersionFormatted, Dimension 3, Vertices</translation>
    </message>
    <message>
        <source>a grasper: the instrument has jaws</source>
        <translation>bir tutucu: aletin çeneleri var</translation>
    </message>
    <message>
        <source>a kind of cell</source>
        <translation>bir hücre türü</translation>
    </message>
    <message>
        <source>a line of corners</source>
        <translation>bir köşe satırı</translation>
    </message>
    <message>
        <source>a mesh of Fluent as text</source>
        <translation>metin olarak bir Fluent ağı</translation>
    </message>
    <message>
        <source>a mesh of Netgen: surfaceelements, points</source>
        <translation>bir Netgen ağı: surfaceelements, points</translation>
    </message>
    <message>
        <source>a model of FEBio</source>
        <translation>bir FEBio modeli</translation>
    </message>
    <message>
        <source>a model of FEBio with its mesh in the same file</source>
        <translation>ağı aynı dosyada olan bir FEBio modeli</translation>
    </message>
    <message>
        <source>a neutral file of Gambit</source>
        <translation>bir Gambit nötr dosyası</translation>
    </message>
    <message>
        <source>a sound file</source>
        <translation>sağlam bir dosya</translation>
    </message>
    <message>
        <source>a surface made of triangles or quadrilaterals, or cells that fill space</source>
        <translation>üçgen ya da dörtgenlerden bir yüzey ya da hacmi dolduran hücreler</translation>
    </message>
    <message>
        <source>a surface of GIFTI: .surf.gii</source>
        <translation>bir GIFTI yüzeyi: .surf.gii</translation>
    </message>
    <message>
        <source>a universal file</source>
        <translation>bir evrensel (UNV) dosya</translation>
    </message>
    <message>
        <source>a universal file of nodes and elements</source>
        <translation>düğüm ve elemanları olan bir evrensel (UNV) dosya</translation>
    </message>
    <message>
        <source>a whole file</source>
        <translation>bütün bir dosya</translation>
    </message>
    <message>
        <source>%1, as places</source>
        <translation>%1, konumlar kadar</translation>
    </message>
    <message>
        <source>Draco, or vertices as plain numbers</source>
        <translation>Draco ya da düz sayı olarak köşeler</translation>
    </message>
    <message>
        <source>a buffer&apos;s %1</source>
        <translation>bir tampondaki %1</translation>
    </message>
    <message>
        <source>a bufferView&apos;s %1</source>
        <translation>bir bufferView içindeki %1</translation>
    </message>
    <message>
        <source>a file beside it</source>
        <translation>yanındaki bir dosya</translation>
    </message>
    <message>
        <source>a glTF</source>
        <translation>bir glTF</translation>
    </message>
    <message>
        <source>a glTF that is whole</source>
        <translation>eksiksiz bir glTF</translation>
    </message>
    <message>
        <source>a glTF&apos;s object</source>
        <translation>bir glTF nesnesi</translation>
    </message>
    <message>
        <source>a list of objects</source>
        <translation>nesnelerin listesi</translation>
    </message>
    <message>
        <source>a mesh packed by Draco</source>
        <translation>Draco ile sıkıştırılmış bir ağ</translation>
    </message>
    <message>
        <source>at most %1 MB</source>
        <translation>en çok %1 MB</translation>
    </message>
    <message>
        <source>data</source>
        <translation>veri</translation>
    </message>
    <message>
        <source>indices and values</source>
        <translation>sıra numaraları ve değerler</translation>
    </message>
    <message>
        <source>meshes that end what unpacks them (%1)</source>
        <translation>açan programı sonlandıran ağlar (%1)</translation>
    </message>
    <message>
        <source>meshes that take too long to unpack</source>
        <translation>açılması çok uzun süren ağlar</translation>
    </message>
    <message>
        <source>meshes that the package %1 unpacks, and it is not there</source>
        <translation>%1 paketinin açtığı ağlar; bu paket kurulu değil</translation>
    </message>
    <message>
        <source>places</source>
        <translation>konumlar</translation>
    </message>
    <message>
        <source>places of vertices</source>
        <translation>köşelerin konumları</translation>
    </message>
    <message>
        <source>rows of %1</source>
        <translation>%1 sayılık satırlar</translation>
    </message>
    <message>
        <source>vectors of plain numbers</source>
        <translation>düz sayılardan vektörler</translation>
    </message>
    <message>
        <source>what it says it has</source>
        <translation>içinde olduğunu söylediği şey</translation>
    </message>
    <message>
        <source>%1 and %2</source>
        <translation>%1 ve %2</translation>
    </message>
    <message>
        <source>%1 and %2: %3</source>
        <translation>%1 ve %2: %3</translation>
    </message>
    <message>
        <source>%1 bodies</source>
        <translation>%1 cisim</translation>
    </message>
    <message>
        <source>a name of its own</source>
        <translation>kendine ait bir ad</translation>
    </message>
    <message>
        <source>a published organ, .palpate</source>
        <translation>yayımlanmış bir organ, .palpate</translation>
    </message>
    <message>
        <source>a region that faces all ways</source>
        <translation>her yöne bakan bir bölge</translation>
    </message>
    <message>
        <source>a region without a triangle</source>
        <translation>üçgeni olmayan bir bölge</translation>
    </message>
    <message>
        <source>a layout</source>
        <translation>bir yerleşim</translation>
    </message>
    <message>
        <source>a record</source>
        <translation>bir kayıt</translation>
    </message>
    <message>
        <source>a published scenario</source>
        <translation>yayımlanmış bir senaryo</translation>
    </message>
    <message>
        <source>a script</source>
        <translation>bir betik</translation>
    </message>
    <message>
        <source>a PNG picture</source>
        <translation>bir PNG resmi</translation>
    </message>
    <message>
        <source>an OBJ mesh</source>
        <translation>bir OBJ ağı</translation>
    </message>
    <message>
        <source>an STL mesh</source>
        <translation>bir STL ağı</translation>
    </message>
    <message>
        <source>a truth</source>
        <translation>bir doğru çözüm</translation>
    </message>
    <message>
        <source>an SVG picture</source>
        <translation>bir SVG resmi</translation>
    </message>
    <message>
        <source>findings of a study</source>
        <translation>bir incelemenin bulguları</translation>
    </message>
    <message>
        <source>the chart of an organ</source>
        <translation>bir organın çizelgesi</translation>
    </message>
    <message>
        <source>the atlas of an organ</source>
        <translation>bir organın atlası</translation>
    </message>
    <message>
        <source>a multi-rate chart</source>
        <translation>bir çoklu hız çizelgesi</translation>
    </message>
    <message>
        <source>the report of a self-test</source>
        <translation>bir öz sınamanın raporu</translation>
    </message>
    <message>
        <source>the report of a replay</source>
        <translation>bir yeniden oynatmanın raporu</translation>
    </message>
    <message>
        <source>the summary of a demo</source>
        <translation>bir tanıtımın özeti</translation>
    </message>
    <message>
        <source>a table of attempts</source>
        <translation>bir denemeler tablosu</translation>
    </message>
    <message>
        <source>a scene of several parts that a layout places</source>
        <translation>bir yerleşimin yerleştirdiği, birkaç parçalı bir sahne</translation>
    </message>
    <message>
        <source>a single organ; `palpate scene` checks and changes layouts</source>
        <translation>tek bir organ; yerleşimleri `palpate scene` denetler ve değiştirir</translation>
    </message>
    <message>
        <source>another file than was added to the layout</source>
        <translation>yerleşime eklenenden başka bir dosya</translation>
    </message>
    <message>
        <source>one side of an organ</source>
        <translation>bir organın bir yüzü</translation>
    </message>
    <message>
        <source>one, an organ that is placed</source>
        <translation>bir tane, yerleştirilen bir organ</translation>
    </message>
    <message>
        <source>some surface</source>
        <translation>biraz yüzey</translation>
    </message>
    <message>
        <source>that one; `palpate scene place %1 %2 --renew` takes this one</source>
        <translation>o dosya; `palpate scene place %1 %2 --renew` bunu alır</translation>
    </message>
    <message>
        <source>two of the bodies, each pair once</source>
        <translation>cisimlerden ikisi, her çift bir kez</translation>
    </message>
    <message>
        <source>an element of Netgen</source>
        <translation>bir Netgen elemanı</translation>
    </message>
    <message>
        <source>an organ</source>
        <translation>bir organ</translation>
    </message>
    <message>
        <source>another kind: the instrument has a shaft or jaws</source>
        <translation>başka bir tür: aletin şaftı ya da çeneleri var</translation>
    </message>
    <message>
        <source>bytes as base64</source>
        <translation>base64 olarak baytlar</translation>
    </message>
    <message>
        <source>colours of other triangles</source>
        <translation>başka üçgenlerin renkleri</translation>
    </message>
    <message>
        <source>corners of faces</source>
        <translation>yüzlerin köşeleri</translation>
    </message>
    <message>
        <source>elements of the lowest order</source>
        <translation>en düşük dereceden elemanlar</translation>
    </message>
    <message>
        <source>elements that are no faces and fill no space were passed over: %1</source>
        <translation>yüz olmayan ve hacim doldurmayan elemanlar atlandı: %1</translation>
    </message>
    <message>
        <source>facets behind them</source>
        <translation>arkalarından yüzler</translation>
    </message>
    <message>
        <source>facets without</source>
        <translation>onsuz yüzler</translation>
    </message>
    <message>
        <source>four or five of a section</source>
        <translation>bir bölümün dört ya da beş sayısı</translation>
    </message>
    <message>
        <source>hexadecimal numbers</source>
        <translation>onaltılık sayılar</translation>
    </message>
    <message>
        <source>hexahedron</source>
        <translation>altı yüzlü</translation>
    </message>
    <message>
        <source>how many points and cells there are</source>
        <translation>kaç nokta ve hücre olduğu</translation>
    </message>
    <message>
        <source>its closing bracket</source>
        <translation>kapanış ayracı</translation>
    </message>
    <message>
        <source>its text (ivcat writes it)</source>
        <translation>metin hâli (ivcat yazar)</translation>
    </message>
    <message>
        <source>mesh3d, which a file of Netgen begins with</source>
        <translation>bir Netgen dosyasının başladığı mesh3d</translation>
    </message>
    <message>
        <source>more %1</source>
        <translation>daha çok %1</translation>
    </message>
    <message>
        <source>more corners of a facet</source>
        <translation>bir yüzün daha çok köşesi</translation>
    </message>
    <message>
        <source>more corners of an element</source>
        <translation>bir elemanın daha çok köşesi</translation>
    </message>
    <message>
        <source>more facets</source>
        <translation>daha çok yüz</translation>
    </message>
    <message>
        <source>more nodes of an element</source>
        <translation>bir elemanın daha çok düğümü</translation>
    </message>
    <message>
        <source>nodes and elements written out</source>
        <translation>açıkça yazılmış düğüm ve elemanlar</translation>
    </message>
    <message>
        <source>none of it beside trocar_m</source>
        <translation>trocar_m yanında hiçbiri</translation>
    </message>
    <message>
        <source>none: the instrument has no trocar</source>
        <translation>hiçbiri: aletin trokarı yok</translation>
    </message>
    <message>
        <source>number, material, kind and corners of a cell</source>
        <translation>bir hücrenin numarası, malzemesi, türü ve köşeleri</translation>
    </message>
    <message>
        <source>numbers of %1</source>
        <translation>%1 sayıları</translation>
    </message>
    <message>
        <source>pyramid</source>
        <translation>piramit</translation>
    </message>
    <message>
        <source>quad</source>
        <translation>dörtgen</translation>
    </message>
    <message>
        <source>rows of 3</source>
        <translation>3'lü satırlar</translation>
    </message>
    <message>
        <source>tetra</source>
        <translation>dört yüzlü</translation>
    </message>
    <message>
        <source>tetrahedra</source>
        <translation>dört yüzlüler</translation>
    </message>
    <message>
        <source>the file it includes</source>
        <translation>içerdiği dosya</translation>
    </message>
    <message>
        <source>the outside of a mesh</source>
        <translation>bir ağın dışı</translation>
    </message>
    <message>
        <source>the points of its cells there</source>
        <translation>hücrelerinin noktaları orada</translation>
    </message>
    <message>
        <source>those of a %1</source>
        <translation>bir %1 için olanlar</translation>
    </message>
    <message>
        <source>three</source>
        <translation>üç</translation>
    </message>
    <message>
        <source>three for each</source>
        <translation>her biri için üç</translation>
    </message>
    <message>
        <source>triangle</source>
        <translation>üçgen</translation>
    </message>
    <message>
        <source>version 1 to 4 of Medit's binary files</source>
        <translation>Medit'in ikili dosyalarının 1 ile 4 arası sürümü</translation>
    </message>
    <message>
        <source>wedge</source>
        <translation>kama</translation>
    </message>
    <message>
        <source>x y z of each point</source>
        <translation>her noktanın x y z değerleri</translation>
    </message>
    <message>
        <source>|u1 of shape (%1, 3)</source>
        <translation>(%1, 3) biçiminde |u1</translation>
    </message>
    <message>
        <source>a name, without /</source>
        <translation>/ içermeyen bir ad</translation>
    </message>
    <message>
        <source>got none, so a trainee reads "%1": `palpate scene set LAYOUT --title "..."` gives it one</source>
        <translation>hiç yok, öğrenci "%1" okur: `palpate scene set LAYOUT --title "..."` ona bir başlık verir</translation>
    </message>
    <message>
        <source>X,Y,Z of up to %1 %2 each</source>
        <translation>X,Y,Z, her biri en çok %1 %2</translation>
    </message>
    <message>
        <source>text that UTF-8 can say</source>
        <translation>UTF-8 ile yazılabilen bir metin</translation>
    </message>
    <message>
        <source>2, or none</source>
        <translation>2 ya da hiç</translation>
    </message>
    <message>
        <source>a scene that a file holds</source>
        <translation>bir dosyanın tuttuğu bir sahne</translation>
    </message>
    <message>
        <source>one, or none</source>
        <translation>bir ya da hiç</translation>
    </message>
    <message>
        <source>one in a layout of version %1</source>
        <translation>%1 sürümlü bir düzende bir tane</translation>
    </message>
    <message>
        <source>some in a layout of version %1</source>
        <translation>%1 sürümlü bir yerleşimde bir şey</translation>
    </message>
    <message>
        <source>%1, where most, expected at most %2 mm: it was scanned as it lies, and here gravity pulls it down once more; `palpate scene place LAYOUT %3 --weightless` takes its shape as the one under its weight</source>
        <translation>%1, en çok gittiği yerde; beklenen en çok %2 mm: durduğu gibi tarandı ve yerçekimi onu burada bir kez daha aşağı çekiyor; `palpate scene place LAYOUT %3 --weightless` biçimini kendi ağırlığı altındaki biçim sayar</translation>
    </message>
    <message>
        <source>%1, where most: gravity, or what it lies on, moves it</source>
        <translation>%1, en çok gittiği yerde: yerçekimi ya da üzerinde durduğu şey onu oynatıyor</translation>
    </message>
    <message>
        <source>%1: got %2 %3, expected %4 %5, as the first body's organ has it</source>
        <translation>%1: %2 %3 bulundu, %4 %5 bekleniyordu: ilk cismin organında olduğu gibi</translation>
    </message>
    <message>
        <source>%1: it falls, expected something that it lies on</source>
        <translation>%1: düşüyor, üzerinde duracağı bir şey bekleniyordu</translation>
    </message>
    <message>
        <source>its hull of %1 spheres lies up to %2 mm in it, expected at most %3 mm: more spheres, or a rounder mesh</source>
        <translation>%1 küreden oluşan zarfı en çok %2 mm içeride kalıyor, en fazla %3 mm bekleniyordu: daha çok küre ya da daha yuvarlak bir ağ</translation>
    </message>
    <message>
        <source>pressed together: %1</source>
        <translation>birbirine bastırılınca: %1</translation>
    </message>
    <message>
        <source>without any hand, with %1 and not with %2: %3</source>
        <translation>hiçbir el yokken, %1 ile ve %2 ile değil: %3</translation>
    </message>
    <message>
        <source>without any hand: %1</source>
        <translation>hiçbir el yokken: %1</translation>
    </message>
    <message>
        <source>within %1 s it goes %2 mm from where it is placed, and moves at %3 mm/s then</source>
        <translation>%1 s içinde konduğu yerden %2 mm uzaklaşıyor ve o zaman %3 mm/s ile hareket ediyor</translation>
    </message>
</context>
</TS>
